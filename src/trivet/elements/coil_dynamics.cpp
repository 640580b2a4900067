// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/coil_dynamics.h"

#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <string>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/up_to_twelve.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {
namespace {

std::vector<Eigen::Index> pivots(Seat seat_n, Seat seat_k) {
  if (seat_n == Seat::pivoted)
    return seat_k == Seat::pivoted ? std::vector<Eigen::Index>{3, 4, 9, 10} : std::vector<Eigen::Index>{3, 4};
  return seat_k == Seat::pivoted ? std::vector<Eigen::Index>{9, 10} : std::vector<Eigen::Index>{};
}

/// Static or dynamic condensation of the motions `free`; their rows and columns become zero.
template <typename Matrix>
Matrix condensed_motions(const Matrix& d, const std::vector<Eigen::Index>& free) {
  if (free.empty()) return d;
  using Block = numerics::UpToTwelve<typename Matrix::Scalar>;
  const Block rows = d(free, Eigen::all), corner = d(free, free);
  Matrix result = d - rows.transpose() * numerics::lu_solution(corner, rows);
  result(free, Eigen::all).setZero();
  result(Eigen::all, free).setZero();
  return result;
}

/// 12×12 at the seats from the blocks at the wire ends. The levers are real, so real and imaginary parts transform
/// separately.
Matrix12 at_seats(const SeatedCoil& coil, const Matrix6& own, const Matrix6& transfer) {
  const Eigen::DiagonalMatrix<double, 6> half_turn(1, -1, -1, 1, -1, -1);
  const Matrix6 own_k = half_turn * own * half_turn;
  Matrix12 d;
  d.topLeftCorner<6, 6>() = coil.wire_from_seat_n.transpose() * Matrix6(own * coil.wire_from_seat_n);
  d.topRightCorner<6, 6>() = coil.wire_from_seat_n.transpose() * Matrix6(transfer * coil.wire_from_seat_k);
  d.bottomRightCorner<6, 6>() = coil.wire_from_seat_k.transpose() * Matrix6(own_k * coil.wire_from_seat_k);
  d.bottomLeftCorner<6, 6>() = d.topRightCorner<6, 6>().transpose();
  return d;
}

void require_finite(bool finite, std::complex<double> omega) {
  if (!finite)
    throw foundation::NotComputable("coil spring: its dynamic stiffness is infinite at " +
                                    foundation::hertz_words(omega.real(), 6) +
                                    ", a natural frequency with both seats held");
}

struct Clamped {
  Matrix12 d;
  int modes;
};

/// Stiffness with both seats clamped, before any pivot is released; d is not finite exactly at a natural frequency.
Clamped clamped_at(const SeatedCoil& coil, double omega) {
  const double lambda = omega * omega;
  const RodStiffness<double> rod = rod_stiffness<double>(coil.rod, lambda, 1.0);
  Clamped clamped{at_seats(coil, rod.own, rod.transfer), rod.clamped_modes};
  clamped.d.topLeftCorner<6, 6>() += coil.second_order_n - lambda * coil.dead_mass_n;
  clamped.d.bottomRightCorner<6, 6>() += coil.second_order_k - lambda * coil.dead_mass_k;
  return clamped;
}

/// Torsion of the straightened, clamped wire: order of magnitude of the spring's surge frequency [rad/s].
double surge(const HelicalRod& rod) {
  return std::sqrt(1 / (rod.moment_flexibility(1) * rod.line_mass)) * rod.curvature.norm() / rod.length;
}

/// The same, with ω shifted slightly if it is exactly a natural frequency, where a pivot is zero and is not counted.
Clamped clamped_beside(const SeatedCoil& coil, double omega) {
  constexpr int most_nudges = 40;
  Clamped clamped = clamped_at(coil, omega);
  double nudge = 2e-16 * std::max(omega, 1e-6 * surge(coil.rod));
  for (int i = 0; i < most_nudges && !clamped.d.allFinite(); ++i, nudge *= 2) clamped = clamped_at(coil, omega + nudge);
  require_finite(clamped.d.allFinite(), omega);
  return clamped;
}

/// Mass matrix of the dead coils as a thin ring about the axis, from the seat at height 0 to `height` (negative at K).
Matrix6 dead_mass(const CoilSpring& spring, double coils, double height) {
  const double radius = spring.mean_diameter / 2;
  const double mass = spring.density * wire_section(spring).area * 2 * std::numbers::pi * radius * coils;
  const double across = mass * (radius * radius / 2 + height * height / 12);
  Matrix6 at_centre = Matrix6::Zero();
  at_centre.diagonal() << mass, mass, mass, across, across, mass * radius * radius;
  const Matrix6 lever = spatial::rigid_motion({0, 0, height / 2});
  return lever.transpose() * at_centre * lever;
}

Matrix6 wire_from_seat(const Helix& line, double angle, double height) {
  return spatial::both_blocks(section_axes(line, angle).transpose()) *
      spatial::rigid_motion(from_axis(line, angle) + Eigen::Vector3d(0, 0, height));
}

}  // namespace

SeatedCoil seated_coil(const CoilSpring& spring) {
  require_sound(spring, true);
  const Helix line = helix(spring);
  const double dead_n = spring.dead_coils_n * wire_height(spring), dead_k = spring.dead_coils_k * wire_height(spring);
  SeatedCoil coil;
  coil.rod = helical_rod(spring);
  coil.wire_from_seat_n = wire_from_seat(line, line.start_angle, dead_n);
  coil.wire_from_seat_k = wire_from_seat(line, line.start_angle + line.turn, -dead_k);
  coil.second_order_n.setZero();
  coil.second_order_k.setZero();
  coil.dead_mass_n = dead_mass(spring, spring.dead_coils_n, dead_n);
  coil.dead_mass_k = dead_mass(spring, spring.dead_coils_k, -dead_k);
  coil.seat_n = spring.seat_n;
  coil.seat_k = spring.seat_k;
  coil.loss_factor = spring.loss_factor;
  return coil;
}

Matrix12 dynamic_stiffness(const SeatedCoil& coil, double angular_frequency) {
  const Clamped clamped = clamped_at(coil, angular_frequency);
  require_finite(clamped.d.allFinite(), angular_frequency);
  return condensed_motions(clamped.d, pivots(coil.seat_n, coil.seat_k));
}

Matrix12c dynamic_stiffness(const SeatedCoil& coil, std::complex<double> angular_frequency) {
  using Complex = std::complex<double>;
  const Complex lambda = angular_frequency * angular_frequency;
  const RodStiffness<Complex> rod = rod_stiffness<Complex>(coil.rod, lambda, Complex(1, coil.loss_factor));
  Matrix12c d;
  d.real() = at_seats(coil, rod.own.real(), rod.transfer.real());
  d.imag() = at_seats(coil, rod.own.imag(), rod.transfer.imag());
  d.topLeftCorner<6, 6>() += coil.second_order_n - lambda * coil.dead_mass_n;
  d.bottomRightCorner<6, 6>() += coil.second_order_k - lambda * coil.dead_mass_k;
  require_finite(d.allFinite(), angular_frequency);
  return condensed_motions(d, pivots(coil.seat_n, coil.seat_k));
}

Matrix12 dynamic_stiffness(const CoilSpring& spring, double angular_frequency) {
  return dynamic_stiffness(seated_coil(spring), angular_frequency);
}

Matrix12c dynamic_stiffness(const CoilSpring& spring, std::complex<double> angular_frequency) {
  return dynamic_stiffness(seated_coil(spring), angular_frequency);
}

int modes_below(const SeatedCoil& coil, double angular_frequency, SeatsHeld held) {
  const Clamped clamped = clamped_beside(coil, angular_frequency);
  std::vector<Eigen::Index> free = pivots(coil.seat_n, held == SeatsHeld::n_only ? Seat::clamped : coil.seat_k);
  const Eigen::Index sliding = held == SeatsHeld::n_only ? 6 : held == SeatsHeld::lateral_slide ? 2 : 0;
  for (Eigen::Index i = 0; i < sliding; ++i) free.push_back(6 + i);
  if (free.empty()) return clamped.modes;
  const Eigen::MatrixXd corner = clamped.d(free, free);
  const Eigen::VectorXd pivot = numerics::ldlt_pivots(corner);
  return clamped.modes + int((pivot.array() < 0).count());
}

std::vector<double> natural_frequencies(const SeatedCoil& coil, SeatsHeld held, int count) {
  constexpr double resolution = 1e-13;
  if (count < 1)
    throw foundation::InvalidInput("natural_frequencies: count " + std::to_string(count) + ", must be ≥ 1");
  double high = surge(coil.rod);
  std::map<double, int> seen = {{0.0, modes_below(coil, 0, held)}};
  for (; seen.rbegin()->second < count; high *= 2) seen.emplace(high, modes_below(coil, high, held));
  std::vector<double> result;
  for (int k = 1; k <= count; ++k) {
    auto above = seen.begin();
    while (above->second < k) ++above;
    double top = above->first, low = above == seen.begin() ? 0 : std::prev(above)->first;
    while (top - low > resolution * top) {
      const double middle = 0.5 * (low + top);
      const int below = modes_below(coil, middle, held);
      seen.emplace(middle, below);
      (below < k ? low : top) = middle;
    }
    result.push_back(0.5 * (low + top));
  }
  return result;
}

std::vector<double> natural_frequencies(const CoilSpring& spring, SeatsHeld held, int count) {
  return natural_frequencies(seated_coil(spring), held, count);
}

}  // namespace trivet::elements
