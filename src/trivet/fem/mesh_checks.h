// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/fem/material.h"
#include "trivet/fem/mesh.h"
#include "trivet/foundation/problems.h"

namespace trivet::fem {

/// All that keeps a mesh from being condensed: node numbers, numbers that are not finite, plates without nodes or with
/// common nodes, elements without material, elements turned inside out, no volume, pieces that hang on no plate or on
/// one only, unsound materials. An error names one offender by number (from 0) and place.
[[nodiscard]] foundation::Problems check_mesh(const Mesh& mesh, const std::vector<Material>& materials);

/// @throws InvalidInput with the first error of `check_mesh`
void require_sound(const Mesh& mesh, const std::vector<Material>& materials);

}  // namespace trivet::fem
