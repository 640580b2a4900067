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
  int free = -1;  ///< index of the value added at each frequency; −1: none
};

/// Nonzero entries of the lower triangle, column by column, in coordinates q = D q̃. Only this function reads the full
/// matrices.
[[nodiscard]] std::vector<SymmetricEntry> symmetric_entries(const DynamicMatrices& matrices, const Eigen::VectorXd& d);

/// An entry of Z(ω), and by symmetry its mirror entry, to which a value given for each frequency is added.
struct FreeEntry {
  Eigen::Index row = 0, column = 0;
};

/// Marks entries as free and adds missing ones. Each at most once, on one side of the diagonal.
void add_free(const std::vector<FreeEntry>& free, std::vector<SymmetricEntry>& entries);

}  // namespace trivet::numerics
