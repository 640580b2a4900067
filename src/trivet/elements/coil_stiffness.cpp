// SPDX-License-Identifier: BSD-3-Clause
// Static 12×12 of a coil spring: flexibility of the wire, summed along it in closed form.
#include <cmath>
#include <vector>

#include "trivet/elements/helical_rod.h"
#include "trivet/numerics/linalg/cholesky.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {
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
