// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "trivet/fem/mesh.h"
#include "trivet/fem/step_faces.h"

namespace trivet::fem {

/// Lengths are those of the scaled solid.
struct StepMeshOptions {
  double size = std::numeric_limits<double>::quiet_NaN();  ///< [m] > 0: edge of the elements away from the bonded rims
  double rim_size =
      0;  ///< [m] edge of the elements at the rims of bonded faces, where stresses are singular; 0: size/4
  double rim_distance = 0;  ///< [m] distance from a rim at which the full size is reached; 0: twice the size
  FaceSelection plate_n = FurthestFaces{-Eigen::Vector3d::UnitZ()}, plate_k = FurthestFaces{Eigen::Vector3d::UnitZ()};
  double scale = 1;         ///< > 0: multiplies all lengths of the file
  double time_limit = 600;  ///< [s] > 0 for the mesher
};

/// Tetrahedra of the solids of a STEP file between the plates or sleeves N and K, in the file's frame.
struct StepMesh {
  Mesh mesh;                               ///< tet10; its materials are the solids, from 0 in the order of the file
  std::vector<StepFace> faces_n, faces_k;  ///< bonded faces
  Eigen::Vector3d centre_n, centre_k;      ///< [m] of the bonded areas: the usual reference points
  int solids = 0;
  double volume = 0;  ///< [m³], exact
};

/// Meshes with gmsh as a child process. Equal files and options give equal meshes. Problems have the subjects "file",
/// "size", "rim_size", "rim_distance", "scale", "plate_n", "plate_k"; mesh.h checks whether the mesh can be
/// condensed.
[[nodiscard]] foundation::Expected<StepMesh> mesh_step(const std::filesystem::path& file,
                                                       const StepMeshOptions& options,
                                                       const foundation::Progress& progress = {});

}  // namespace trivet::fem
