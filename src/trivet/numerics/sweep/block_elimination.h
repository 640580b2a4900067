// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/linalg/symmetric_entries.h"

namespace trivet::numerics {

/// Largest number of coordinates of a block: its rows stay in registers and on the stack of the kernels.
inline constexpr int largest_kernel_block = 8;

/// Columns with entries for each row of a symmetric matrix, ascending.
using Couplings = std::vector<std::vector<int>>;

[[nodiscard]] Couplings couplings(Eigen::Index rows, const std::vector<SymmetricEntry>& entries);

/// Elimination order of the blocks of a symmetric matrix, and the blocks that the elimination fills. Found once for all
/// frequencies.
struct BlockElimination {
  std::vector<Eigen::Index> rows;       ///< row of the given matrix for each row in elimination order
  std::vector<Eigen::Index> first;      ///< first row of each block in that order, and the end
  std::vector<std::vector<int>> below;  ///< later blocks coupled to each block when it is eliminated, ascending

  [[nodiscard]] int count() const { return static_cast<int>(below.size()); }
  [[nodiscard]] int size(int block) const { return static_cast<int>(first[block + 1] - first[block]); }
};

/// Minimum degree on the graph of blocks (Tinney and Walker 1967): the block with the fewest coupled rows comes next;
/// among equals one without load, to shorten the substitution of the load, then the first one. Linear for chains and
/// trees: no fill-in.
/// @param starts  first row of each block, ascending from 0
/// @param loaded  for each row, whether it may have a load
[[nodiscard]] BlockElimination block_elimination(const Couplings& couplings, const std::vector<Eigen::Index>& starts,
                                                 const std::vector<bool>& loaded);

/// Complex multiply-adds of one factorisation and one solution.
[[nodiscard]] double multiply_adds(const BlockElimination& elimination);

/// Cost of these and of the visits to blocks, in multiply-adds of six-by-six blocks.
[[nodiscard]] double cost(const BlockElimination& elimination);

/// Cheapest elimination: with the given blocks if any, else the best of blocks of six, of three, and runs of
/// neighbouring rows with similar couplings.
/// @param given  see `DynamicMatrices::blocks`
[[nodiscard]] BlockElimination cheapest_block_elimination(const Couplings& couplings,
                                                          const std::vector<Eigen::Index>& given,
                                                          const std::vector<bool>& loaded);

}  // namespace trivet::numerics
