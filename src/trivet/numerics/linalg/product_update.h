// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>

#include "trivet/numerics/lanes/line_memory.h"

namespace trivet::numerics {

/// Rows and columns of the part of a product that the registers hold.
struct TileSize {
  std::ptrdiff_t rows, columns;
};

/// Which entries of a matrix are needed.
enum class Needed { all, lower_triangle };

/// C ← C − A Bᵀ for large dense matrices, with the best instructions of this processor. A has the rows, B the columns
/// of C, both have as many columns as there are products to add: efficient for 64 to 192. The object keeps its working
/// memory for the next update.
class ProductUpdate {
 public:
  using Block = Eigen::Ref<Eigen::MatrixXd>;
  using ConstBlock = Eigen::Ref<const Eigen::MatrixXd>;

  /// @param needed  `lower_triangle`: entries above the diagonal of C are undefined afterwards
  /// @param threads  at most; the result does not depend on it
  void subtract(const ConstBlock& a, const ConstBlock& b, Block c, Needed needed, int threads = 1);

 private:
  LineMemory a_, b_;
};

}  // namespace trivet::numerics
