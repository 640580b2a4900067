// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/helical_rod.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::elements {

namespace {

template <typename Scalar>
using Square = Eigen::Matrix<Scalar, 6, 6>;

/// States that are even and odd under the half turn about axis 1, as indices in (u, θ, F, M): the rod's equations are
/// even' = B odd, odd' = C even, which leaves 6×6 instead of 12×12.
constexpr std::array<int, 6> even_states = {0, 3, 7, 8, 10, 11};
constexpr std::array<int, 6> odd_states = {1, 2, 4, 5, 6, 9};
/// Displacements in the order of those lists, as indices in (u, θ): two even, four odd.
constexpr std::array<int, 6> displacements = {0, 3, 1, 2, 4, 5};

template <typename Scalar>
struct Rates {
  Square<Scalar> of_even;  ///< B
  Square<Scalar> of_odd;   ///< C
};

template <typename Scalar>
Eigen::Matrix<Scalar, 3, 3> cross(const Eigen::Matrix<Scalar, 3, 1>& v) {
  Eigen::Matrix<Scalar, 3, 3> m;
  m << Scalar(0), -v(2), v(1), v(2), Scalar(0), -v(0), -v(1), v(0), Scalar(0);
  return m;
}

/// Terms of the preload: A₁₁ and A₂₁ of the Hamiltonian system, moments referred to rotation vectors (half of θ × M₀
/// split off).
template <typename Scalar>
void add_preload(Eigen::Matrix<Scalar, 12, 12>& a, const Eigen::Matrix<Scalar, 3, 1>& tangent,
                 const Eigen::Matrix<Scalar, 3, 1>& force_flexibility,
                 const Eigen::Matrix<Scalar, 3, 1>& moment_flexibility, const Eigen::Matrix<Scalar, 3, 1>& force,
                 const Eigen::Matrix<Scalar, 3, 1>& moment) {
  using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
  const Matrix3 f = cross(force), m = cross(moment), r = cross(tangent);
  const Matrix3 stretch = force_flexibility.asDiagonal() * f;
  const Matrix3 bend = Scalar(0.5) * (moment_flexibility.asDiagonal() * m);
  a.template block<3, 3>(0, 3) += stretch;
  a.template block<3, 3>(3, 3) += bend;
  a.template block<3, 3>(9, 6) -= stretch.transpose();
  a.template block<3, 3>(9, 9) -= bend.transpose();
  a.template block<3, 3>(9, 3) += f * stretch + Scalar(0.5) * (m * bend) - Scalar(0.5) * (f * r + r * f);
}

/// Rates of change along the rod with `unit` as unit of length and EI₂/unit² as unit of force.
template <typename Scalar>
Rates<Scalar> rates(const HelicalRod& rod, Scalar lambda, Scalar load, double unit) {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  const double bending = 1 / rod.moment_flexibility(1), force_unit = bending / (unit * unit);
  const Vector3 curvature = (unit * rod.curvature).cast<Scalar>(), tangent = rod.tangent.cast<Scalar>();
  const Vector3 force_flexibility = (force_unit * rod.force_flexibility).cast<Scalar>();
  const Vector3 moment_flexibility = (bending * rod.moment_flexibility).cast<Scalar>();
  Eigen::Matrix<Scalar, 12, 12> a = Eigen::Matrix<Scalar, 12, 12>::Zero();
  for (int i = 0; i < 12; i += 3) a.template block<3, 3>(i, i) = -cross(curvature);
  a.template block<3, 3>(0, 3) = -cross(tangent);
  a.template block<3, 3>(9, 6) = -cross(tangent);
  a.template block<3, 3>(0, 6).diagonal() = force_flexibility;
  a.template block<3, 3>(3, 9).diagonal() = moment_flexibility;
  a.template block<3, 3>(6, 0).diagonal().setConstant(-lambda * Scalar(rod.line_mass * unit * unit / force_unit));
  a.template block<3, 3>(9, 3).diagonal() = -lambda * (rod.line_inertia / force_unit).cast<Scalar>();
  if (rod.force.squaredNorm() + rod.moment.squaredNorm() > 0)
    add_preload<Scalar>(a, tangent, force_flexibility, moment_flexibility,
                        load * (rod.force / force_unit).cast<Scalar>(),
                        load * (rod.moment / (force_unit * unit)).cast<Scalar>());
  Rates<Scalar> result;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      result.of_even(int(i), int(j)) = a(even_states[i], odd_states[j]);
      result.of_odd(int(i), int(j)) = a(odd_states[i], even_states[j]);
    }
  return result;
}

/// Σ Xᵏ/(2k + first)! to k = 11, for ‖X‖ of about 1: the first omitted term is below 1e-25.
template <typename Scalar>
Square<Scalar> series(const Square<Scalar>& x, const Square<Scalar>& x2, const Square<Scalar>& x3, int first) {
  std::array<Scalar, 12> c;
  Scalar factorial = first == 1 ? Scalar(1) : Scalar(2);
  for (std::size_t k = 0; k < 12; ++k) {
    c[k] = Scalar(1) / factorial;
    factorial *= Scalar(double((2 * int(k) + first + 1) * (2 * int(k) + first + 2)));
  }
  const Square<Scalar> one = Square<Scalar>::Identity();
  Square<Scalar> sum = c[9] * one + c[10] * x + c[11] * x2;
  sum = c[6] * one + c[7] * x + c[8] * x2 + Square<Scalar>(x3 * sum);
  sum = c[3] * one + c[4] * x + c[5] * x2 + Square<Scalar>(x3 * sum);
  return c[0] * one + c[1] * x + c[2] * x2 + x3 * sum;
}

/// L D Lᵀ of a small symmetric (not Hermitian) matrix, largest diagonal entry first; counts negative pivots.
template <typename Scalar, int N>
struct SymmetricFactors {
  Eigen::Matrix<Scalar, N, N> lower;
  std::array<int, N> order;
  int negative = 0;

  explicit SymmetricFactors(Eigen::Matrix<Scalar, N, N> m) {
    for (int i = 0; i < N; ++i) order[std::size_t(i)] = i;
    for (int k = 0; k < N; ++k) {
      int best = k;
      for (int i = k + 1; i < N; ++i)
        if (std::abs(m(i, i)) > std::abs(m(best, best))) best = i;
      if (best != k) {
        m.row(k).swap(m.row(best));
        m.col(k).swap(m.col(best));
        std::swap(order[std::size_t(k)], order[std::size_t(best)]);
      }
      if (std::real(m(k, k)) < 0) ++negative;
      const Scalar inverse = Scalar(1) / m(k, k);
      for (int i = k + 1; i < N; ++i) {
        const Scalar factor = m(i, k) * inverse;
        for (int j = k + 1; j <= i; ++j) m(i, j) -= factor * m(j, k), m(j, i) = m(i, j);
      }
      for (int i = k + 1; i < N; ++i) m(i, k) *= inverse;
    }
    lower = m;
  }
  /// Bᵀ M⁻¹ B.
  Square<Scalar> congruence(const Eigen::Matrix<Scalar, N, 6>& b) const {
    Eigen::Matrix<Scalar, N, 6> x, scaled;
    for (int i = 0; i < N; ++i) {
      x.row(i) = b.row(order[std::size_t(i)]);
      for (int k = 0; k < i; ++k) x.row(i) -= lower(i, k) * x.row(k);
      scaled.row(i) = x.row(i) / lower(i, i);
    }
    return x.transpose() * scaled;
  }
};

/// K₊ = own + transfer·J and K₋ = own − transfer·J: stiffness when the ends move alike or opposite under the half turn.
template <typename Scalar>
struct Halves {
  Square<Scalar> alike, opposite;
};

template <typename Scalar>
Square<Scalar> force_per_motion(const Square<Scalar>& even, const Square<Scalar>& odd) {
  Square<Scalar> motion, wrench;
  motion << even.template topRows<2>(), -odd.template topRows<4>();
  wrench << odd.template bottomRows<2>(), -even.template bottomRows<4>();
  const Eigen::Matrix<Scalar, 6, 6, Eigen::RowMajor> coefficients = motion.transpose();
  const Square<Scalar> right = wrench.transpose(), k = numerics::lu_solution(coefficients, right);
  return Scalar(0.5) * (k + k.transpose());
}

template <typename Scalar>
Halves<Scalar> segment(const Rates<Scalar>& rate, int squarings) {
  const Square<Scalar> x = rate.of_even * rate.of_odd, x2 = x * x, x3 = x2 * x, one = Square<Scalar>::Identity();
  const Square<Scalar> s1 = series(x, x2, x3, 1), s2 = series(x, x2, x3, 2);
  Square<Scalar> even_even = one + x * s2, odd_even = rate.of_odd * s1, even_odd = s1 * rate.of_even;
  Square<Scalar> odd_odd = one + rate.of_odd * Square<Scalar>(s2 * rate.of_even);
  for (int i = 0; i < squarings; ++i) {
    odd_even = Scalar(2) * Square<Scalar>(odd_even * even_even);
    even_odd = Scalar(2) * Square<Scalar>(even_odd * odd_odd);
    even_even = Scalar(2) * Square<Scalar>(even_even * even_even) - one;
    odd_odd = Scalar(2) * Square<Scalar>(odd_odd * odd_odd) - one;
  }
  return {force_per_motion<Scalar>(even_even, odd_even), force_per_motion<Scalar>(even_odd, odd_odd)};
}

/// Joins two equal segments; returns the number of negative pivots of their common point.
template <typename Scalar>
int join(Halves<Scalar>& k) {
  const Square<Scalar> sum = k.alike + k.opposite, difference = Scalar(0.5) * (k.alike - k.opposite);
  const SymmetricFactors<Scalar, 2> even(sum.template topLeftCorner<2, 2>());
  const SymmetricFactors<Scalar, 4> odd(sum.template bottomRightCorner<4, 4>());
  const Square<Scalar> own = Scalar(0.5) * sum;
  k.alike = own - Scalar(2) * even.congruence(difference.template topRows<2>());
  k.opposite = own - Scalar(2) * odd.congruence(difference.template bottomRows<4>());
  return even.negative + odd.negative;
}

double largest_wave_number(const HelicalRod& rod, double lambda) {
  const double bending = std::max(rod.moment_flexibility(0), rod.moment_flexibility(1));
  const double shear =
      std::max(rod.force_flexibility(0) * rod.line_mass, rod.moment_flexibility(2) * rod.line_inertia(2));
  return std::max(std::pow(lambda * rod.line_mass * bending, 0.25), std::sqrt(lambda * shear));
}

/// Longest first segment, as wave number × length: below the lowest clamped natural frequency of a straight piece (π in
/// shear and torsion), so that joining counts every natural frequency.
constexpr double longest_wave = 2;
/// The same as curvature × length, 1.6 turns: too short to buckle. With a shorter one, doubling loses digits of the
/// lateral stiffness.
constexpr double longest_arc = 10;
/// Largest half-length for the series, over 1/curvature and 1/wave number.
constexpr double series_reach = 0.5;

int halvings(double ratio) { return ratio > 1 ? int(std::ceil(std::log2(ratio))) : 0; }

}  // namespace

template <typename Scalar>
RodStiffness<Scalar> rod_stiffness(const HelicalRod& rod, Scalar lambda, Scalar modulus) {
  const double curvature = rod.curvature.norm();
  const double waves = largest_wave_number(rod, double(std::abs(lambda / modulus)));
  const int doublings = halvings(rod.length * std::max(waves / longest_wave, curvature / longest_arc));
  const double half = 0.5 * std::ldexp(rod.length, -doublings);
  const int squarings = halvings(half * std::max(curvature, waves) / series_reach);
  const double unit = std::ldexp(half, -squarings);
  Halves<Scalar> k = segment<Scalar>(rates<Scalar>(rod, lambda / modulus, Scalar(1) / modulus, unit), squarings);
  RodStiffness<Scalar> result;
  for (int i = 0; i < doublings; ++i) result.clamped_modes = 2 * result.clamped_modes + join(k);

  const double force_unit = 1 / (rod.moment_flexibility(1) * unit * unit);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const int row = displacements[i], column = displacements[j];
      const double measure = force_unit / unit * (row < 3 ? 1 : unit) * (column < 3 ? 1 : unit);
      const Scalar alike = k.alike(int(i), int(j)), opposite = k.opposite(int(i), int(j));
      result.own(row, column) = Scalar(0.5 * measure) * modulus * (alike + opposite);
      result.transfer(row, column) = Scalar(0.5 * measure) * modulus * (j < 2 ? alike - opposite : opposite - alike);
    }
  return result;
}

template RodStiffness<double> rod_stiffness(const HelicalRod&, double, double);
template RodStiffness<std::complex<double>> rod_stiffness(const HelicalRod&, std::complex<double>,
                                                          std::complex<double>);
template RodStiffness<long double> rod_stiffness(const HelicalRod&, long double, long double);

Helix helix(const CoilSpring& spring) {
  const double turn = 2 * std::numbers::pi * spring.active_coils, radius = spring.mean_diameter / 2;
  return {.radius = radius,
          .lead = std::atan2(spring.active_length, turn * radius),
          .turn = spring.hand == Hand::right ? turn : -turn,
          .height = spring.active_length,
          .start_angle = spring.start_angle};
}

Eigen::Matrix3d section_axes(const Helix& helix, double angle) {
  const double hand = helix.turn < 0 ? -1 : 1;
  const Eigen::Vector3d inward(-std::cos(angle), -std::sin(angle), 0);
  const Eigen::Vector3d along(-hand * std::cos(helix.lead) * std::sin(angle),
                              hand * std::cos(helix.lead) * std::cos(angle), std::sin(helix.lead));
  Eigen::Matrix3d axes;
  axes << inward, along.cross(inward), along;
  return axes;
}

Eigen::Vector3d from_axis(const Helix& helix, double angle) {
  return {helix.radius * std::cos(angle), helix.radius * std::sin(angle), 0};
}

HelicalRod helical_rod(const CoilSpring& spring) {
  const Helix line = helix(spring);
  const WireSection section = wire_section(spring);
  const double E = spring.youngs_modulus, G = spring.shear_modulus, A = section.area, hand = line.turn < 0 ? -1 : 1;
  HelicalRod rod;
  rod.length = std::hypot(line.radius * line.turn, line.height);
  rod.curvature =
      std::abs(line.turn) / rod.length * Eigen::Vector3d(0, std::cos(line.lead), hand * std::sin(line.lead));
  rod.tangent = Eigen::Vector3d::UnitZ();
  const double shear = 1 / (section.shear_factor * G * A);
  rod.force_flexibility = {shear, shear, 1 / (E * A)};
  rod.moment_flexibility = {1 / (E * section.second_moments(0)), 1 / (E * section.second_moments(1)),
                            1 / (G * section.torsion_constant)};
  rod.line_mass = spring.density * A;
  rod.line_inertia = spring.density * section.second_moments;
  return rod;
}

}  // namespace trivet::elements
