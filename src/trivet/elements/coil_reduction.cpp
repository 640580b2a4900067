// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/coil_reduction.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "trivet/elements/helical_rod.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {

namespace {

using Complex = std::complex<double>;
using Weight = std::function<Complex(Complex)>;

/// (1/2πi) ∮ weight(λ) D(λ) dλ on a circle about a real centre; D is real on the real axis, so half the circle is
/// enough. The trapezoidal rule has the error `ratio`^points, with the larger of the two ratios of a pole's distance
/// and the radius.
Matrix12 circle_integral(const SeatedCoil& coil, double centre, double radius, double ratio, const Weight& weight) {
  constexpr double accuracy = 1e-15;
  const int half = int(std::ceil(0.5 * std::log(accuracy) / std::log(ratio)));
  Matrix12 sum = Matrix12::Zero();
  for (int j = 0; j < half; ++j) {
    const Complex arm = std::polar(radius, (j + 0.5) * std::numbers::pi / half), lambda = centre + arm;
    sum += (weight(lambda) * arm * dynamic_stiffness(coil, std::sqrt(lambda))).real();
  }
  return sum / half;
}

/// Eigenvalues λ closer than this, relatively, are separated by algebra and not by circles.
constexpr double close = 1e-3;

/// Eigenvalues first … last (excluded) of a group and its distance to the nearest other eigenvalue, or to 0.
struct Group {
  std::size_t first, last;
  double low, high, gap;
};

std::vector<Group> groups(const std::vector<double>& lambda, std::size_t wanted) {
  std::vector<Group> result;
  for (std::size_t first = 0, last = 0; first < wanted; first = last) {
    for (last = first + 1; last < lambda.size() && lambda[last] - lambda[last - 1] < close * lambda[last]; ++last) {
    }
    if (last == lambda.size()) return {};
    const double below = first == 0 ? 0 : lambda[first - 1];
    result.push_back({first, last, lambda[first], lambda[last - 1],
                      std::min(lambda[first] - below, lambda[last] - lambda[last - 1])});
  }
  return result;
}

/// Columns c_k of one group from Σ c_k c_kᵀ and Σ (λ_k − centre) c_k c_kᵀ; `scale` makes translations and rotations
/// comparable.
Eigen::Matrix<double, 12, Eigen::Dynamic> couplings(const SeatedCoil& coil, const Group& group,
                                                    const spatial::Vector12& scale) {
  const auto count = Eigen::Index(group.last - group.first);
  const double centre = 0.5 * (group.low + group.high), spread = 0.5 * (group.high - group.low),
               radius = spread + 0.5 * group.gap;
  const double ratio = std::max(spread / radius, radius / (spread + group.gap));
  const auto moment = [&](const Weight& weight) -> Matrix12 {
    const Matrix12 sum = circle_integral(coil, centre, radius, ratio, weight);
    return scale.asDiagonal() * (0.5 * (sum + sum.transpose())) * scale.asDiagonal();
  };
  const Matrix12 order0 = moment([](Complex lambda) { return 1.0 / (lambda * lambda); });
  const numerics::SymmetricEigen<Matrix12> eigen = numerics::symmetric_eigen(order0);
  const Eigen::VectorXd size = eigen.values.tail(count).cwiseMax(0).cwiseSqrt();
  Eigen::Matrix<double, 12, Eigen::Dynamic> columns = eigen.vectors.rightCols(count) * size.asDiagonal();
  if (count > 1) {
    const Matrix12 order1 = moment([&](Complex lambda) { return (lambda - centre) / (lambda * lambda); });
    const Eigen::MatrixXd back = eigen.vectors.rightCols(count) * size.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd inner = back.transpose() * order1 * back;
    columns = (columns * numerics::symmetric_eigen(inner).vectors).eval();
  }
  for (Eigen::Index i = 0; i < 12; ++i)
    if (scale(i) > 0) columns.row(i) /= scale(i);
  return columns;
}

std::vector<double> squared_frequencies(const SeatedCoil& coil, int count) {
  std::vector<double> lambda = natural_frequencies(coil, SeatsHeld::both, count);
  for (double& value : lambda) value *= value;
  return lambda;
}

/// Static mass −dD/dλ at λ = 0, by a circle well inside the first pole.
Matrix12 static_mass(const SeatedCoil& coil, double first_pole) {
  constexpr double inside = 0.125;
  const Matrix12 slope =
      circle_integral(coil, 0, inside * first_pole, inside, [](Complex lambda) { return 1.0 / (lambda * lambda); });
  return -0.5 * (slope + slope.transpose());
}

}  // namespace

ReducedCoil reduced(const SeatedCoil& with_loss, int modes) {
  if (modes < 0)
    throw foundation::InvalidInput("reduced coil spring: " + std::to_string(modes) + " modes, must be ≥ 0");
  SeatedCoil coil = with_loss;
  coil.loss_factor = 0;
  const auto wanted = std::size_t(modes);
  std::vector<double> lambda = squared_frequencies(coil, modes + 2);
  std::vector<Group> all = groups(lambda, wanted);
  while (wanted > 0 && all.empty()) {
    lambda = squared_frequencies(coil, int(lambda.size()) + 4);
    all = groups(lambda, wanted);
  }

  ReducedCoil result;
  result.stiffness = dynamic_stiffness(coil, 0.0);
  result.mass = static_mass(coil, lambda[0]);
  const spatial::Vector12 scale =
      result.mass.diagonal().unaryExpr([](double m) { return m > 0 ? 1 / std::sqrt(m) : 0.0; });
  result.natural_frequencies.resize(modes);
  result.coupling.resize(12, modes);
  for (const Group& group : all) {
    const Eigen::Matrix<double, 12, Eigen::Dynamic> columns = couplings(coil, group, scale);
    for (std::size_t k = group.first; k < std::min(group.last, wanted); ++k) {
      result.natural_frequencies(Eigen::Index(k)) = std::sqrt(lambda[k]);
      result.coupling.col(Eigen::Index(k)) = columns.col(Eigen::Index(k - group.first));
    }
  }
  return result;
}

ReducedCoil reduced(const CoilSpring& spring, int modes) {
  ReducedCoil result = reduced(seated_coil(spring), modes);
  result.stiffness = stiffness(spring);
  return result;
}

Eigen::MatrixXd ReducedCoil::extended_stiffness() const {
  const Eigen::Index m = natural_frequencies.size();
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(12 + m, 12 + m);
  k.topLeftCorner<12, 12>() = stiffness;
  k.bottomRightCorner(m, m).diagonal() = natural_frequencies.array().square();
  return k;
}

Eigen::MatrixXd ReducedCoil::extended_mass() const {
  const Eigen::Index m = natural_frequencies.size();
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(12 + m, 12 + m);
  a.topLeftCorner<12, 12>() = mass;
  a.topRightCorner(12, m) = coupling;
  a.bottomLeftCorner(m, 12) = coupling.transpose();
  return a;
}

namespace {

/// Flexibility of the wire per metre, wrench and motion at the axis point of its height, in (radial, tangential, axial)
/// axes.
Matrix6 line_flexibility(const Helix& line, const HelicalRod& rod) {
  const Eigen::Matrix3d axes = section_axes(line, 0);
  Matrix6 section_wrench = spatial::both_blocks(axes.transpose());
  section_wrench.bottomLeftCorner<3, 3>() = -axes.transpose() * spatial::cross_matrix(from_axis(line, 0));
  Vector6 flexibility;
  flexibility << rod.force_flexibility, rod.moment_flexibility;
  return section_wrench.transpose() * flexibility.asDiagonal() * section_wrench;
}

/// The same turned by the angle φ about the axis is Σ of these times 1, cos φ, sin φ, cos² φ, sin² φ, sin φ cos φ.
struct Harmonics {
  Matrix6 one, cosine, sine, cosine_squared, sine_squared, product;
};

Harmonics harmonics(const Matrix6& flexibility) {
  Eigen::Matrix3d axial = Eigen::Matrix3d::Zero(), plane = Eigen::Matrix3d::Identity(),
                  quarter = Eigen::Matrix3d::Zero();
  axial(2, 2) = 1, plane(2, 2) = 0, quarter(0, 1) = -1, quarter(1, 0) = 1;
  const Matrix6 z = spatial::both_blocks(axial), p = spatial::both_blocks(plane), q = spatial::both_blocks(quarter);
  const Matrix6 zf = z * flexibility, pf = p * flexibility, qf = q * flexibility;
  return {zf * z, zf * p + pf * z,    zf * q.transpose() + qf * z,
          pf * p, qf * q.transpose(), pf * q.transpose() + qf * p};
}

/// Flexibility of the whole wire at the middle of its axis, in axes with the first towards the middle of the wire:
/// ∫ (I + zN)ᵀ f(φ) (I + zN) ds over φ from −b to b, with z = rise · φ. Odd terms vanish.
Matrix6 flexibility_at_middle(const Helix& line, const HelicalRod& rod) {
  const Harmonics f = harmonics(line_flexibility(line, rod));
  const double b = std::abs(line.turn) / 2, s = std::sin(b), c = std::cos(b), s2 = std::sin(2 * b),
               c2 = std::cos(2 * b);
  const double length = rod.length / std::abs(line.turn), rise = line.height / line.turn;
  const double twice = b * b * s2 + b * c2 - s2 / 2, cube = 2 * b * b * b / 3;
  const Matrix6 order0 =
      2 * b * f.one + 2 * s * f.cosine + (b + s * c) * f.cosine_squared + (b - s * c) * f.sine_squared;
  const Matrix6 order1 = 2 * (s - b * c) * f.sine + (s2 / 4 - b * c2 / 2) * f.product;
  const Matrix6 order2 = cube * f.one + 2 * ((b * b - 2) * s + 2 * b * c) * f.cosine +
      (cube + twice) / 2 * f.cosine_squared + (cube - twice) / 2 * f.sine_squared;
  Matrix6 lever = Matrix6::Zero();
  lever.bottomLeftCorner<3, 3>() = -rise * spatial::cross_matrix(Eigen::Vector3d::UnitZ());
  const Matrix6 skewed = order1 * lever;
  return length * (order0 + skewed + skewed.transpose() + lever.transpose() * order2 * lever);
}

/// Components of a wrench that both seats carry when it acts at `height` on the axis: at a pivot no moment about e1 and
/// e2, between two pivots only force and moment along the axis.
struct TransmittedComponents {
  std::vector<Eigen::Index> components;
  double height;
};

TransmittedComponents transmitted_components(const CoilSpring& spring) {
  const bool pivot_n = spring.seat_n == Seat::pivoted, pivot_k = spring.seat_k == Seat::pivoted;
  const double top = seat_distance(spring),
               middle = spring.dead_coils_n * wire_height(spring) + spring.active_length / 2;
  if (pivot_n && pivot_k) return {{2, 5}, middle};
  if (pivot_n || pivot_k) return {{0, 1, 2, 5}, pivot_n ? 0 : top};
  return {{0, 1, 2, 3, 4, 5}, middle};
}

/// Inverse of the carried part of a flexibility, zero elsewhere.
Matrix6 inverse_of(const Matrix6& flexibility, const std::vector<Eigen::Index>& components) {
  const Vector6 scale = flexibility.diagonal().cwiseSqrt().cwiseInverse();
  const Matrix6 unit = scale.asDiagonal() * flexibility * scale.asDiagonal();
  const Eigen::MatrixXd part = unit(components, components);
  Matrix6 inverse = Matrix6::Zero();
  const Eigen::MatrixXd part_inverse =
      numerics::cholesky_solution(part, Eigen::MatrixXd(Eigen::MatrixXd::Identity(part.rows(), part.cols())));
  inverse(components, components) = part_inverse;
  const Matrix6 result = scale.asDiagonal() * inverse * scale.asDiagonal();
  return 0.5 * (result + result.transpose());
}

}  // namespace

Matrix12 stiffness(const CoilSpring& spring) {
  require_sound(spring, false);
  const Helix line = helix(spring);
  const TransmittedComponents at = transmitted_components(spring);
  const double middle = spring.dead_coils_n * wire_height(spring) + spring.active_length / 2;
  const Matrix6 turn =
      spatial::both_blocks(spatial::rotation_about(Eigen::Vector3d::UnitZ(), line.start_angle + line.turn / 2));
  const Matrix6 carry = spatial::rigid_motion(Eigen::Vector3d(0, 0, at.height - middle)) * turn;
  const Matrix6 flexibility = carry * flexibility_at_middle(line, helical_rod(spring)) * carry.transpose();
  const Matrix6 to_k = spatial::rigid_motion(Eigen::Vector3d(0, 0, at.height - seat_distance(spring)));
  const Matrix6 at_k = to_k.transpose() * inverse_of(flexibility, at.components) * to_k;
  return from_moved_end(at_k, {0, 0, seat_distance(spring)});
}

}  // namespace trivet::elements
