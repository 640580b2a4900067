// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"
#include "trivet/solids/primitives.h"

namespace trivet::solids {

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

/// A piece of uniform density.
struct Part {
  std::string name;
  std::variant<Box, Cylinder, Tube, Sphere, Cone, StlSolid, StepSolid> shape;
  double density = not_given;  ///< [kg/m³] > 0
  spatial::Pose pose = {};     ///< of the shape's frame in the body's frame, whose origin is the pole
};

struct PartResult {
  std::string name;
  double volume = 0;                   ///< [m³]
  spatial::MassProperties properties;  ///< from the pole in body axes, as for the sum
};

struct RigidSolid {
  spatial::MassProperties properties;  ///< of all parts together, from the pole in body axes
  std::vector<PartResult> parts;
  foundation::Problems remarks;  ///< warnings
};

/// Mass, centre and inertia of all parts together; overlapping volumes count twice. Subjects of problems are the part's
/// name and the key, "flange.density".
[[nodiscard]] foundation::Expected<RigidSolid> rigid_solid(const std::vector<Part>& parts,
                                                           const foundation::Progress& progress = {});

}  // namespace trivet::solids
