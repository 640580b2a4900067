// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/friction.h"

#include <cmath>

namespace trivet::elements {

BristleDecay bristle_decay(const LuGreFriction& law, double rate, double sense) {
  const double towards = sense < 0 ? -1 : 1;
  if (!law.has_stribeck_effect()) return {towards * law.stiffness / law.slip, 0};
  const double ratio = rate / law.stribeck_velocity, above = (law.breakaway - law.slip) * std::exp(-ratio * ratio),
               steady = law.slip + above, per_travel = towards * law.stiffness / steady;
  return {per_travel, per_travel * 2 * ratio / law.stribeck_velocity * above / steady};
}

VirginBristles virgin_force(const LuGreFriction& law, double deflection) {
  const double reached = -std::expm1(-law.stiffness * std::abs(deflection) / law.limit());
  return {std::copysign(law.limit() * reached, deflection), law.stiffness * (1 - reached)};
}

double least_passive_viscous(const LuGreFriction& law) { return law.damping * (law.limit() / law.slip - 1); }

using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

Vector2d across(const Vector2d& direction) { return {-direction.y(), direction.x()}; }

/// Without any travel only the size changes.
Slip scaled(double stiffness, const Vector2d& start, double limit_before, double limit) {
  Slip found;
  const double size = start.norm();
  if (size == 0) return found;
  const Vector2d along = start / size, side = across(along);
  found.force = limit * along;
  found.by_start = limit / size * side * side.transpose();
  if (limit_before > 0) found.by_travel = stiffness * limit / limit_before * side * side.transpose();
  found.by_limit = along;
  return found;
}

/// Mean of 1/L while L changes evenly from a to b, ln(b/a)/(b − a), and its derivative by a; that by b is the same with
/// both exchanged.
struct MeanInverse {
  double value = 0, by_first = 0;
};
MeanInverse mean_inverse(double a, double b) {
  const double x = (b - a) / (a + b);  // ln(b/a) = 2 artanh x
  constexpr double by_series = 1e-2;
  double ratio = 0, slope = 0;  // artanh(x)/x, and its derivative over x
  if (std::abs(x) < by_series) {
    const double square = x * x;
    ratio = 1 + square * (1.0 / 3 + square * (1.0 / 5 + square / 7));
    slope = 2.0 / 3 + square * (4.0 / 5 + square * 6 / 7);
  } else {
    ratio = std::atanh(x) / x;
    slope = (1 / (1 - x * x) - ratio) / (x * x);
  }
  const double sum = a + b, value = 2 * ratio / sum;
  return {value, -value / sum - 2 * slope * x / sum * (2 * b / (sum * sum))};
}

}  // namespace

Slip slip(double stiffness, const Vector2d& start, const Vector2d& travel, double limit_before, double limit) {
  const double distance = travel.norm(), size = start.norm();
  if (distance == 0) return scaled(stiffness, start, limit_before, limit);
  const Vector2d towards = travel / distance, aside = across(towards);
  Slip found;
  constexpr double vanishing = 1e-12;  // as a contact closes or opens, where it turns at once
  if (size == 0 || !(limit_before > vanishing * limit) || !(limit > vanishing * limit_before)) {
    found.force = limit * towards;
    found.by_travel = limit / distance * aside * aside.transpose();
    found.by_limit = towards;
    return found;
  }
  const MeanInverse of_before = mean_inverse(limit_before, limit);
  // Half of the angle from the travel to the force.
  const double per_limit = of_before.value, turns = stiffness * distance * per_limit, kept = std::exp(-turns),
               half = std::atan2(aside.dot(start), towards.dot(start)) / 2, c = std::cos(half), s = std::sin(half),
               after = std::hypot(c, kept * s), cos_half = c / after, sin_half = kept * s / after;
  const double cosine = cos_half * cos_half - sin_half * sin_half, sine = 2 * sin_half * cos_half;
  const Vector2d along = cosine * towards + sine * aside, side = across(along);
  found.force = limit * along;
  const double by_angle = kept / (after * after), by_turns = -sine;  // of the angle after
  // The angle of the force is that of the travel and the one between them.
  const Vector2d angle_by_start = by_angle * across(start) / (size * size);
  const Vector2d angle_by_travel = (1 - by_angle) / distance * aside + by_turns * stiffness * per_limit * towards;
  found.by_start = limit * side * angle_by_start.transpose();
  found.by_travel = limit * side * angle_by_travel.transpose();
  const double by_per_limit = by_turns * stiffness * distance;
  found.by_limit = along + limit * by_per_limit * mean_inverse(limit, limit_before).by_first * side;
  found.by_limit_before = limit * by_per_limit * of_before.by_first * side;
  return found;
}

Slip slip_on_wall(double stiffness, const Vector2d& start, const Vector2d& travel, double limit_before, double limit,
                  double hoop) {
  const Eigen::DiagonalMatrix<double, 2> across(hoop, 1), back(1 / hoop, 1);
  const Slip friction = slip(stiffness, across * start, across * travel, limit_before, limit);
  Slip found;
  found.force = back * friction.force;
  found.by_start = back * friction.by_start * across;
  found.by_travel = back * friction.by_travel * across;
  found.by_limit = back * friction.by_limit;
  found.by_limit_before = back * friction.by_limit_before;
  found.by_hoop = back * (friction.by_start.col(0) * start.x() + friction.by_travel.col(0) * travel.x());
  found.by_hoop.x() -= found.force.x() / hoop;
  return found;
}

}  // namespace trivet::elements
