// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/fem/material.h"
#include "trivet/fem/mesh.h"
#include "trivet/foundation/problems.h"

namespace trivet::fem {

/// All reasons why a mesh cannot be condensed: wrong node numbers, non-finite coordinates, plates without nodes or with
/// common nodes, elements without material, inverted elements, no volume, pieces on no plate, no piece that connects
/// the plates, invalid materials. An error gives one example by number (from 0) and position.
[[nodiscard]] foundation::Problems check_mesh(const Mesh& mesh, const std::vector<Material>& materials);

/// @throws InvalidInput with the first error of `check_mesh`
void require_sound(const Mesh& mesh, const std::vector<Material>& materials);

}  // namespace trivet::fem
