// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/primitives.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/part_size.h"

namespace trivet::solids {
namespace {

using foundation::Problems;
using std::numbers::pi;

enum class Zero { refused, allowed };

void check_length(Problems& problems, const char* name, double length, Zero zero = Zero::refused) {
  if (foundation::is_part_size(length) || (zero == Zero::allowed && length == 0)) return;
  if (length > 0 && std::isfinite(length)) {
    problems.error(name, fmt::format("{:.6g} m", length), foundation::part_size_rule,
                   "check the unit and the power of ten");
    return;
  }
  problems.error(name, std::isnan(length) ? "not given" : fmt::format("{:.6g} m", length),
                 zero == Zero::allowed ? "a diameter of a cone must be ≥ 0" : "a length of a solid must be > 0",
                 "give it as a length with its unit");
}

void check(const Box& box, Problems& problems) {
  check_length(problems, "length_x", box.length_x);
  check_length(problems, "length_y", box.length_y);
  check_length(problems, "length_z", box.length_z);
}

void check(const Cylinder& cylinder, Problems& problems) {
  check_length(problems, "diameter", cylinder.diameter);
  check_length(problems, "length", cylinder.length);
}

void check(const Tube& tube, Problems& problems) {
  check_length(problems, "outer_diameter", tube.outer_diameter);
  check_length(problems, "inner_diameter", tube.inner_diameter);
  check_length(problems, "length", tube.length);
  if (tube.inner_diameter >= tube.outer_diameter)
    problems.error("inner_diameter",
                   fmt::format("{:.6g} m, outer_diameter = {:.6g} m: wall {:.6g} m", tube.inner_diameter,
                               tube.outer_diameter, (tube.outer_diameter - tube.inner_diameter) / 2),
                   "a tube's inner diameter must be below its outer diameter",
                   "exchange the two, or use a cylinder if it has no bore");
}

void check(const Sphere& sphere, Problems& problems) { check_length(problems, "diameter", sphere.diameter); }

void check(const Cone& cone, Problems& problems) {
  check_length(problems, "start_diameter", cone.start_diameter, Zero::allowed);
  check_length(problems, "end_diameter", cone.end_diameter, Zero::allowed);
  check_length(problems, "length", cone.length);
  if (cone.start_diameter == 0 && cone.end_diameter == 0)
    problems.error("end_diameter", "both diameters are 0 m", "one end of a cone must have a diameter > 0",
                   "give the diameter of the wide end");
}

VolumeIntegrals symmetric(double volume, double xx, double yy, double zz) {
  return {volume, Eigen::Vector3d::Zero(), Eigen::Vector3d(xx, yy, zz).asDiagonal()};
}

VolumeIntegrals integrals_of(const Box& b) {
  const double v = b.length_x * b.length_y * b.length_z;
  return symmetric(v, v * b.length_x * b.length_x / 12, v * b.length_y * b.length_y / 12,
                   v * b.length_z * b.length_z / 12);
}

VolumeIntegrals integrals_of(const Tube& t) {
  const double outer = t.outer_diameter / 2, inner = t.inner_diameter / 2;
  const double v = pi * (outer - inner) * (outer + inner) * t.length;
  const double across = v * (outer * outer + inner * inner) / 4;
  return symmetric(v, across, across, v * t.length * t.length / 12);
}

VolumeIntegrals integrals_of(const Cylinder& c) { return integrals_of(Tube{c.diameter, 0, c.length}); }

VolumeIntegrals integrals_of(const Sphere& s) {
  const double r = s.diameter / 2, v = 4 * pi / 3 * r * r * r;
  return symmetric(v, v * r * r / 5, v * r * r / 5, v * r * r / 5);
}

/// With r(z) = m + d·z/L over −L/2 … L/2, m the mean and d the difference of the end radii: V = π L (m² + d²/12),
/// ∫z dV = π L² m d/6, ∫z² dV = π L³ (m²/12 + d²/80), ∫x² dV = π L (m⁴ + m²d²/2 + d⁴/80)/4.
VolumeIntegrals integrals_of(const Cone& c) {
  const double m = (c.start_diameter + c.end_diameter) / 4, d = (c.end_diameter - c.start_diameter) / 2, l = c.length;
  VolumeIntegrals cone;
  cone.volume = pi * l * (m * m + d * d / 12);
  cone.centre.z() = pi * l * l * m * d / 6 / cone.volume;
  const double across = pi * l / 4 * (m * m * m * m + m * m * d * d / 2 + d * d * d * d / 80);
  const double along = pi * l * l * l * (m * m / 12 + d * d / 80) - cone.volume * cone.centre.z() * cone.centre.z();
  cone.second_moment = Eigen::Vector3d(across, across, along).asDiagonal();
  return cone;
}

}  // namespace

Problems problems(const Primitive& primitive) {
  Problems found;
  std::visit([&](const auto& shape) { check(shape, found); }, primitive);
  return found;
}

VolumeIntegrals integrals(const Primitive& primitive) {
  const Problems found = problems(primitive);
  if (found.has_errors()) throw foundation::InvalidInput(message(found.list().front()));
  return std::visit([](const auto& shape) { return integrals_of(shape); }, primitive);
}

}  // namespace trivet::solids
