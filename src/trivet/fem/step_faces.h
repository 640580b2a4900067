// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <variant>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::fem {

/// One face of the solids in a STEP file, in the file's frame.
struct StepFace {
  int number = 0;             ///< from 1, the same for the same file
  double area = 0;            ///< [m²], exact
  Eigen::Vector3d centre;     ///< [m] of its area
  Eigen::Vector3d low, high;  ///< [m] bounds of its points
  Eigen::Matrix3Xd points;    ///< [m] on it, from a coarse mesh of second order
};

struct StepFaces {
  std::vector<StepFace> faces;
  int solids = 0;     ///< numbered from 0 in the order of the file, as Mesh::material
  double volume = 0;  ///< [m³] of all solids, exact
};

/// Faces of all solids of a STEP file; solids that touch are joined first, so that their common face is one face.
/// `scale` multiplies all lengths. Problems: those of solids::run_gmsh; solids that overlap.
[[nodiscard]] foundation::Expected<StepFaces> step_faces(const std::filesystem::path& file, double scale = 1,
                                                         const foundation::Progress& progress = {});

/// gmsh script that joins touching solids. Face numbers are those after joining.
extern const char* const joining_script;

/// The plane faces normal to `direction` that are furthest along it: the usual seat.
struct FurthestFaces {
  Eigen::Vector3d direction;
};
/// All faces completely inside the box between two corners [m].
struct FacesInBox {
  Eigen::Vector3d low, high;
};
/// All faces on a circular cylinder: a sleeve.
struct FacesOnCylinder {
  double radius;  ///< [m] > 0
  Eigen::Vector3d point = Eigen::Vector3d::Zero(), axis = Eigen::Vector3d::UnitZ();
};
struct FacesByNumber {
  std::vector<int> numbers;
};
using FaceSelection = std::variant<FurthestFaces, FacesInBox, FacesOnCylinder, FacesByNumber>;

/// Indices into `faces` of the selected faces. No face, or a number that does not exist, is a problem with the subject
/// `subject`; it lists the existing faces.
[[nodiscard]] foundation::Expected<std::vector<std::size_t>> selected_faces(const StepFaces& all,
                                                                            const FaceSelection& selection,
                                                                            const std::string& subject);

}  // namespace trivet::fem
