// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// An entry of symmetric Z(ω) = K + iK_loss + iωB − ω²A in its lower triangle.
struct SymmetricEntry {
  Eigen::Index row = 0, column = 0;
  double A = 0, B = 0, K = 0, loss = 0;
  int free = -1;  ///< number of what is added at each frequency, or nothing is
};

/// Those of the lower triangle that are not 0, column by column, in coordinates q = D q̃; the only look at the full
/// matrices.
[[nodiscard]] std::vector<SymmetricEntry> symmetric_entries(const DynamicMatrices& matrices, const Eigen::VectorXd& d);

/// An entry of Z(ω), and by symmetry the one across the diagonal, to which something is added that is given for each
/// frequency.
struct FreeEntry {
  Eigen::Index row = 0, column = 0;
};

/// Marks entries as free, adding those that are not there. Each at most once, on one side of the diagonal.
void add_free(const std::vector<FreeEntry>& free, std::vector<SymmetricEntry>& entries);

}  // namespace trivet::numerics
