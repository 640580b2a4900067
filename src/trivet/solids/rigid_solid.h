// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"
#include "trivet/solids/closed_surface.h"

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

/// A closed surface of triangles. STL files do not state their unit, so it must be given.
struct StlSolid {
  std::filesystem::path file;
  double length_unit = not_given;  ///< [m] > 0: length of 1 in the file; 0.001 for millimetres
};

/// Solids of a STEP file, which states its unit.
struct StepSolid {
  std::filesystem::path file;
  std::vector<int> solids = {};  ///< their numbers from 1 in the order of the file; empty: all
};

/// A piece of uniform density, which is given, or follows from its mass or from that of the whole.
struct Part {
  std::string name;
  std::variant<Box, Cylinder, Tube, Sphere, Cone, StlSolid, StepSolid> shape;
  double density = not_given;  ///< [kg/m³] > 0
  spatial::Pose pose = {};     ///< of the shape's frame in the body's frame, whose origin is the pole
  double mass = not_given;     ///< [kg] > 0, instead of density
};

/// What is known of a body besides its solids.
struct KnownMass {
  /// [kg] > 0, of solids and lumps together: solids without a mass of their own share what the others leave in
  /// proportion to their density × volume, or to their volume if none of them has a density.
  double whole = not_given;
  std::vector<spatial::MassProperties> lumps = {};  ///< parts without a shape, from the pole in body axes
};

struct PartResult {
  std::string name;
  double volume = 0;                   ///< [m³]
  spatial::MassProperties properties;  ///< from the pole in body axes, as for the sum
};

struct RigidSolid {
  spatial::MassProperties properties;  ///< of all parts and lumps together, from the pole in body axes
  std::vector<PartResult> parts;
  foundation::Problems remarks;  ///< warnings
};

/// Mass, centre and inertia of all parts together; overlapping volumes count twice. Subjects of problems are the part's
/// name and the key, "flange.density", or "mass" of the whole.
[[nodiscard]] foundation::Expected<RigidSolid> rigid_solid(const std::vector<Part>& parts, const KnownMass& known = {},
                                                           const foundation::Progress& progress = {});

}  // namespace trivet::solids
