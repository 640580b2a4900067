// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <variant>

#include "trivet/foundation/problems.h"
#include "trivet/solids/volume_integrals.h"

namespace trivet::solids {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

// Simple shapes. The origin of a shape's frame is at the middle of its length, its axis is z. All lengths [m], > 0.

struct Box {
  double length_x = not_given, length_y = not_given, length_z = not_given;
};
struct Cylinder {
  double diameter = not_given, length = not_given;
};
struct Tube {
  double outer_diameter = not_given, inner_diameter = not_given;  ///< inner < outer
  double length = not_given;
};
struct Sphere {
  double diameter = not_given;
};
/// Frustum of a circular cone from z = −length/2 to z = +length/2. One of the two diameters may be 0.
struct Cone {
  double start_diameter = not_given, end_diameter = not_given, length = not_given;
};
using Primitive = std::variant<Box, Cylinder, Tube, Sphere, Cone>;

/// Rules of the shape that its lengths violate, with the length's name as subject.
[[nodiscard]] foundation::Problems problems(const Primitive& primitive);

/// Exact volume, centre and second moment in the shape's frame.
/// @throws InvalidInput if problems(primitive) has errors
[[nodiscard]] VolumeIntegrals integrals(const Primitive& primitive);

}  // namespace trivet::solids
