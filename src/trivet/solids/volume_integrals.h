// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

}  // namespace trivet::solids
