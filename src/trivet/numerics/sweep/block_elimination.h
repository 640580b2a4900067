// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/linalg/symmetric_entries.h"

namespace trivet::numerics {

/// Coordinates of a block, at most: its rows stay in registers and on the stack of the kernels.
inline constexpr int largest_kernel_block = 8;

/// For each row of a symmetric matrix the columns where it has entries, ascending.
using Couplings = std::vector<std::vector<int>>;

[[nodiscard]] Couplings couplings(Eigen::Index rows, const std::vector<SymmetricEntry>& entries);

/// In which order blocks of rows of a symmetric matrix are eliminated, and which blocks the elimination fills. Found
/// once for all frequencies.
struct BlockElimination {
  std::vector<Eigen::Index> rows;       ///< given row of each row in the order of elimination
  std::vector<Eigen::Index> first;      ///< first row of each block in that order, and the end
  std::vector<std::vector<int>> below;  ///< later blocks that each block is coupled to when its turn comes, ascending

  [[nodiscard]] int count() const { return static_cast<int>(below.size()); }
  [[nodiscard]] int size(int block) const {
    return static_cast<int>(first[static_cast<std::size_t>(block) + 1] - first[static_cast<std::size_t>(block)]);
  }
};

/// Minimum degree on the graph of blocks (Tinney and Walker 1967): the block with the fewest coupled rows comes next;
/// among equals one without load, so that a load has a short way, then the first one. Linear for chains and trees:
/// nothing is filled.
/// @param starts  first row of each block, ascending from 0
/// @param loaded  for each row whether a right side may be there
[[nodiscard]] BlockElimination block_elimination(const Couplings& couplings, const std::vector<Eigen::Index>& starts,
                                                 const std::vector<bool>& loaded);

/// Complex multiply-adds of one factorisation and one solution.
[[nodiscard]] double multiply_adds(const BlockElimination& elimination);

/// What they take together with the visits to blocks, in multiply-adds of six by six.
[[nodiscard]] double cost(const BlockElimination& elimination);

/// First rows of the blocks that make the elimination cheapest, out of those given if any, else blocks of six, of
/// three, and runs of neighbouring rows with much the same couplings.
/// @param given  see `DynamicMatrices::blocks`
[[nodiscard]] BlockElimination cheapest_block_elimination(const Couplings& couplings,
                                                          const std::vector<Eigen::Index>& given,
                                                          const std::vector<bool>& loaded);

}  // namespace trivet::numerics
