// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/coil_preload.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/search/zeros_and_minima.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {
namespace {

/// Uniform helix under an axial tension: lead and radius of the sections, rise per metre of wire, moment that prevents
/// rotation.
struct UniformState {
  double tension, lead, radius, rise, moment;
};

/// Equilibrium and law of the rod for a given tension. Turns per metre of wire are constant; the lead is the unknown.
UniformState state_under(const HelicalRod& rod, const Helix& free, double tension) {
  const double turn_rate = rod.curvature.norm(), sine0 = std::sin(free.lead), cosine0 = std::cos(free.lead);
  const double shear = rod.force_flexibility(1), stretch = rod.force_flexibility(2);
  const auto radius = [&](double a) {
    return (1 + std::sin(a) * (stretch - shear) * tension) * std::cos(a) / turn_rate;
  };
  const auto bending = [&](double a) { return turn_rate * (std::cos(a) - cosine0) / rod.moment_flexibility(1); };
  const auto torsion = [&](double a) { return turn_rate * (std::sin(a) - sine0) / rod.moment_flexibility(2); };
  const auto excess = [&](double a) {
    return radius(a) * tension + std::sin(a) * bending(a) - std::cos(a) * torsion(a);
  };
  // Tension opens the coils and compression closes them. At the free lead the excess has the sign of the tension, on a
  // wire that is straight along the axis, up or down, the opposite one.
  if (!(radius(free.lead) > 0 && std::isfinite(excess(free.lead))))
    throw foundation::NotComputable(fmt::format("coil spring: no equilibrium under a tension of {:g} N", tension));
  const double lead = numerics::zero_between(free.lead, std::copysign(std::numbers::pi / 2, tension), excess);
  const double s = std::sin(lead), c = std::cos(lead), hand = free.turn < 0 ? -1 : 1;
  return {tension, lead, radius(lead), s + (c * c * shear + s * s * stretch) * tension,
          hand * (c * bending(lead) + s * torsion(lead))};
}

/// Tension at which a metre of wire rises by this much, < 1.
double tension_at(const HelicalRod& rod, const Helix& free, double rise) {
  constexpr int most_doublings = 60;
  const auto excess = [&](double tension) { return state_under(rod, free, tension).rise - rise; };
  const double at_rest = excess(0);
  if (at_rest == 0) return 0;
  double near = 0,
         far = -2 * at_rest / (free.radius * free.radius * rod.moment_flexibility(2));  // twice the linear one
  for (int i = 0; (excess(far) > 0) == (at_rest > 0); ++i) {
    if (i == most_doublings) throw foundation::NotComputable("coil spring: its rise does not follow its tension");
    near = far, far *= 2;
  }
  return numerics::zero_between(near, far, excess);
}

/// Geometric stiffness for rotations of the foot of a lever with a force at its end.
Matrix6 second_order(const Eigen::Vector3d& lever, const Eigen::Vector3d& force) {
  Matrix6 k = Matrix6::Zero();
  const Eigen::Matrix3d product = lever * force.transpose();
  k.bottomRightCorner<3, 3>() = 0.5 * (product + product.transpose()) - product.trace() * Eigen::Matrix3d::Identity();
  return k;
}

CompressedCoil compressed(const CoilSpring& spring, const Helix& free, const UniformState& state) {
  CompressedCoil result;
  result.coil = seated_coil(spring);
  HelicalRod& rod = result.coil.rod;
  const double hand = free.turn < 0 ? -1 : 1, s = std::sin(state.lead), c = std::cos(state.lead),
               turn_rate = rod.curvature.norm();
  const double lever = state.radius * state.tension;
  result.line = {state.radius, state.lead, free.turn, state.rise * rod.length, free.start_angle};
  rod.curvature = turn_rate * Eigen::Vector3d(0, c, hand * s);
  rod.force = state.tension * Eigen::Vector3d(0, hand * c, s);
  rod.moment = {0, hand * state.moment * c - lever * s, state.moment * s + hand * lever * c};
  rod.tangent = Eigen::Vector3d::UnitZ() + rod.force_flexibility.cwiseProduct(rod.force);

  const Eigen::Vector3d force(0, 0, state.tension);
  const double end_angle = free.start_angle + free.turn, dead_n = spring.dead_coils_n * wire_height(spring);
  const double dead_k = spring.dead_coils_k * wire_height(spring);
  const Eigen::Vector3d lever_n = from_axis(result.line, free.start_angle) + Eigen::Vector3d(0, 0, dead_n);
  const Eigen::Vector3d lever_k = from_axis(result.line, end_angle) - Eigen::Vector3d(0, 0, dead_k);
  result.coil.wire_from_seat_n =
      spatial::both_blocks(section_axes(result.line, free.start_angle).transpose()) * spatial::rigid_motion(lever_n);
  result.coil.wire_from_seat_k =
      spatial::both_blocks(section_axes(result.line, end_angle).transpose()) * spatial::rigid_motion(lever_k);
  result.coil.second_order_n = second_order(lever_n, -force);
  result.coil.second_order_k = second_order(lever_k, force);

  result.compression = free.height - result.line.height;
  result.axial_force = -state.tension;
  result.axial_moment = state.moment;
  result.wire_height = wire_height(spring);
  result.seat_distance = seat_distance(spring) - result.compression;
  result.preload << -force, 0, 0, -state.moment, force, 0, 0, state.moment;
  return result;
}

/// Number of active coils from which the ends hardly disturb the uniform helix (agreement/coil_exact_rod_test).
constexpr double coils_of_a_uniform_helix = 4;

/// Largest compression: the coils touch when the pitch equals the height of the wire.
double solid_compression(const CoilSpring& spring) {
  return spring.active_length - spring.active_coils * wire_height(spring);
}

std::string millimetres(double value) {
  std::ostringstream text;
  text << 1e3 * value << " mm";
  return text.str();
}

void require_open(const CoilSpring& spring, double compression) {
  if (!(compression <= solid_compression(spring)))
    throw foundation::InvalidInput("coil spring: compressed by " + millimetres(compression) + ", its coils touch at " +
                                   millimetres(solid_compression(spring)));
}

/// The density does not affect statics, but the rod needs a value.
CoilSpring with_some_density(CoilSpring spring) {
  if (std::isnan(spring.density)) spring.density = 1;
  return spring;
}

/// State at a compression, without its tangent stiffness.
CompressedCoil at_compression(const CoilSpring& given, double compression) {
  const CoilSpring spring = with_some_density(given);
  const Helix free = helix(spring);
  const HelicalRod rod = helical_rod(spring);
  const double rise = (free.height - compression) / rod.length;
  if (!(rise < 1))
    throw foundation::NotComputable("coil spring: stretched by " + millimetres(-compression) +
                                    ", to the length of its wire or more");
  const UniformState state = state_under(rod, free, compression == 0 ? 0 : tension_at(rod, free, rise));
  constexpr double found = 1e-9;  // not reached where the coil would snap to another shape
  if (!(std::abs(state.rise - rise) <= found))
    throw foundation::NotComputable("coil spring: no equilibrium found when compressed by " + millimetres(compression));
  return compressed(spring, free, state);
}

}  // namespace

CompressedCoil compressed_by(const CoilSpring& spring, double compression) {
  require_sound(spring, false);
  require_open(spring, compression);
  CompressedCoil result = at_compression(spring, compression);
  result.stiffness = dynamic_stiffness(result.coil, 0.0);
  return result;
}

CompressedCoil compressed_with(const CoilSpring& given, double axial_force) {
  require_sound(given, false);
  const CoilSpring spring = with_some_density(given);
  if (!std::isfinite(axial_force)) throw foundation::InvalidInput("coil spring: its axial force must be finite");
  const Helix free = helix(spring);
  CompressedCoil result = compressed(spring, free, state_under(helical_rod(spring), free, -axial_force));
  require_open(spring, result.compression);
  result.stiffness = dynamic_stiffness(result.coil, 0.0);
  return result;
}

std::optional<Buckling> buckling(const CoilSpring& spring, SeatsHeld held) {
  constexpr int steps = 64;
  constexpr double resolution = 1e-12;
  require_sound(spring, false);
  const auto buckled = [&](double compression) {
    return modes_below(at_compression(spring, compression).coil, 0, held) > 0;
  };
  const double solid = solid_compression(spring);
  for (int i = 1; i <= steps; ++i) {
    double high = solid * i / steps, low = solid * (i - 1) / steps;
    if (!buckled(high)) continue;
    while (high - low > resolution * solid) {
      const double middle = 0.5 * (low + high);
      (buckled(middle) ? high : low) = middle;
    }
    return Buckling{high, at_compression(spring, high).axial_force};
  }
  return std::nullopt;
}

std::optional<double> standard_buckling(const CoilSpring& spring) {
  constexpr double parallel_seats = 0.5;
  require_sound(spring, false);
  const double ratio = spring.shear_modulus / spring.youngs_modulus;
  const double slenderness = std::numbers::pi * spring.mean_diameter / (parallel_seats * spring.active_length);
  const double root = 1 - (1 - ratio) / (0.5 + ratio) * slenderness * slenderness;
  if (root < 0) return std::nullopt;
  const double compression = spring.active_length * 0.5 / (1 - ratio) * (1 - std::sqrt(root));
  return compression <= solid_compression(spring) ? std::optional(compression) : std::nullopt;
}

foundation::Problems check_compression(const CoilSpring& spring, double compression) {
  constexpr double near = 0.8;
  foundation::Problems problems = check(spring);
  if (problems.has_errors()) return problems;
  const double solid = solid_compression(spring);
  if (!(compression <= solid)) {
    problems.error("compression", millimetres(compression), "the coils touch at " + millimetres(solid),
                   "reduce the load or use a longer spring");
    return problems;
  }
  if (compression != 0 && spring.active_coils < coils_of_a_uniform_helix) {
    std::ostringstream coils;
    coils << spring.active_coils << " active coils";
    problems.warning(
        "compression", coils.str(),
        "the compressed state is that of a uniform helix, accurate to 2 % for a clamped spring of 4 coils or more",
        spring.active_coils < 2.5
            ? "expect errors up to 13 % in its force, and in its lateral stiffness up to 12 % of the unloaded one; "
              "measure it if that matters"
            : "expect errors up to 3 % in its force, and in its lateral stiffness up to 4 % of the unloaded one");
  }
  const std::optional<Buckling> limit = buckling(spring, SeatsHeld::both);
  if (!limit || compression < near * limit->compression) return problems;
  if (compression >= limit->compression)
    problems.error("compression", millimetres(compression),
                   "with both seats held the spring buckles at " + millimetres(limit->compression),
                   "guide the spring, or use a shorter or wider one");
  else
    problems.warning("compression", millimetres(compression),
                     "it is within 20 % of buckling at " + millimetres(limit->compression),
                     "guide the spring, or use a shorter or wider one");
  return problems;
}

}  // namespace trivet::elements
