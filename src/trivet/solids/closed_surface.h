// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/solids/stl_file.h"
#include "trivet/spatial/mass_properties.h"

namespace trivet::solids {

/// Volume V = ∫dV [m³], its centre [m] and its central second moment ∫(x − c)(x − c)ᵀ dV [m⁵], in the axes of its
/// frame.
struct VolumeIntegrals {
  double volume = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
};

/// The same volume in the parent frame, in which its frame has the pose `pose`.
[[nodiscard]] VolumeIntegrals placed(const VolumeIntegrals& integrals, const spatial::Pose& pose);

/// Sum of two volumes (overlaps count twice).
[[nodiscard]] VolumeIntegrals sum(const VolumeIntegrals& first, const VolumeIntegrals& second);

/// Mass properties, J = ρ (tr(M) I − M) with M the second moment. @param density [kg/m³], > 0
[[nodiscard]] spatial::MassProperties mass_properties(const VolumeIntegrals& integrals, double density);

/// Volume inside a closed surface of triangles: exact integrals over the polyhedron, in the units of its file.
struct EnclosedVolume {
  VolumeIntegrals integrals;
  int shells = 0;                  ///< connected parts of the surface
  int cavities = 0;                ///< shells that face inwards, inside another shell
  foundation::Problems remarks{};  ///< warnings: rounding, repeated or degenerate triangles, edges where shells touch
};

/// Volume enclosed by a surface that is closed (each edge used once in each direction, after rounding and repeated
/// triangles are removed: welded_surface.h) and faces outwards. Otherwise all problems with their place in the file's
/// coordinates: holes, reversed triangles, shells inside out, no volume. Subject "file". Self-intersecting surfaces are
/// not detected.
[[nodiscard]] foundation::Expected<EnclosedVolume> enclosed_volume(const TriangleSurface& given);

}  // namespace trivet::solids
