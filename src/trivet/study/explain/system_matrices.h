// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// A q̈ + B q̇ + (K + iK_loss) q = h of the whole system in its free coordinates, SI.
struct SystemMatrices {
  std::vector<std::string> coordinates;  ///< "machine.x", …, then coordinates inside foundations and elements
  std::vector<std::string> units;        ///< "m", "rad"; "1" for coordinates inside elements and modal ones
  numerics::DynamicMatrices matrices;
  bool exact = true;  ///< false: elements depend on frequency, and B and K are of their nearest linear system
  /// h of all harmonic excitations together, motions of the ground included; vanishes without any
  numerics::Load load = numerics::Load(Eigen::Index{0});
};

[[nodiscard]] SystemMatrices system_matrices(const project::Case& variant);

/// Names of the free coordinates in the order of the rows.
[[nodiscard]] std::vector<std::string> row_names(const model::System& system, const assembly::Assembled& assembled);

/// Units of these: "m", "rad", or "1".
[[nodiscard]] std::vector<std::string> row_units(const model::System& system, const assembly::Assembled& assembled);

}  // namespace trivet::study
