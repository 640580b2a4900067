// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/linalg/symmetric_entries.h"
#include "trivet/numerics/sweep/block_elimination.h"

namespace trivet::numerics {

/// LDLᵀ of K + iK_loss + iωB − ω²A by blocks, spelled out in flat arrays: what to do for a frequency without looking
/// anything up. Rows stand in the order of elimination.
struct BlockPlan {
  /// A block of L, and before that of the matrix: on the diagonal its packed lower triangle, else row by row.
  struct Block {
    int rows = 0, columns = 0;
    bool diagonal = false, has_A = false, has_B = false, has_K = false, has_loss = false;
    std::size_t values = 0;  ///< in `values`: its entries of K, K_loss, B, A, as many of these as it has
    bool kept = false;       ///< L is kept; else it is used up at once, as the given block is as good and far smaller
    std::size_t place = 0;   ///< of one that is kept, among the factors
    std::size_t free_first = 0, free_end = 0;  ///< in `free`
    [[nodiscard]] bool has_free() const { return free_end > free_first; }
    [[nodiscard]] bool is_filled() const {
      return !(has_A || has_B || has_K || has_loss || has_free());
    }  ///< by the elimination only
    [[nodiscard]] int entries() const { return diagonal ? rows * (rows + 1) / 2 : rows * columns; }
  };
  /// A block below the diagonal of a column; those of one column follow each other.
  struct Below {
    int block = 0;
    std::size_t row = 0;    ///< its first row
    bool first = false;     ///< kept, and nothing has been subtracted from it
    std::size_t place = 0;  ///< among all that are below in this column
  };
  /// target −= left D rightᵀ
  struct Update {
    int target = 0;                   ///< in `blocks`
    std::size_t left = 0, right = 0;  ///< in `below`
    bool first = false;               ///< the target must be assembled before
  };
  struct Column {
    int size = 0, diagonal = 0;
    std::size_t row = 0;
    bool first = false;   ///< nothing has been subtracted from its diagonal
    bool loaded = false;  ///< its right side can differ from 0
    std::size_t below_first = 0, below_end = 0, update_first = 0, update_end = 0;
  };
  struct Free {
    std::size_t entry = 0;   ///< within the block
    std::size_t number = 0;  ///< which of the free entries
    double scale = 1;        ///< it is multiplied by this
    std::size_t row = 0, column = 0;
  };
  struct LoadRow {
    std::size_t row = 0;
    std::complex<double> value;
  };
  struct Term {
    LoadTerm given;
    std::vector<LoadRow> rows;          ///< those of `given` that are not 0, in the order of elimination
    std::complex<double> weighted = 0;  ///< wᵀ of it
  };
  /// An entry of the whole matrix with all its values, for residuals.
  struct Entry {
    std::size_t column = 0;
    double A = 0, B = 0, K = 0, loss = 0;
    int free = -1;  ///< in `free`, or none
  };

  std::size_t rows = 0, factors = 0, widest = 0;  ///< `widest`: entries of all blocks below one column, at most
  std::vector<Column> columns;
  std::vector<Block> blocks;
  std::vector<Below> below;
  std::vector<Update> updates;
  std::vector<Free> free;
  std::vector<double> values;
  std::vector<Term> load;
  std::vector<std::size_t> entry_first;  ///< of each row in `entries`, and the end
  std::vector<Entry> entries;
  std::vector<std::size_t> large_rows;  ///< those with the largest sums in one of the matrices
  std::vector<std::size_t> given_row;   ///< given row of each row
  std::vector<double> scale;            ///< a solution of row i is multiplied by this
  /// wᵀA … and w, for a residual seen through one fixed direction w with ½ ≤ |w_i| ≤ 1.
  std::vector<double> weight, weighted_A, weighted_B, weighted_K, weighted_loss;
  bool given_load = false;  ///< the right side is given for each frequency
  double multiply_adds = 0;

  static constexpr int passes = 2;  ///< packs of frequencies that are solved side by side
  static constexpr int together =
      64;  ///< frequencies whose solutions are written together: lines of each plane, not numbers
  static constexpr std::size_t pack = 16;  ///< numbers in a complex pack of the widest lanes
  /// Complex packs for one pass beside its solutions.
  [[nodiscard]] std::size_t packs() const {
    return factors + 2 * widest + (given_load ? 2 : 1) * rows + load.size() + free.size();
  }
  /// Numbers that a solver needs, some even for no rows: empty arrays begin somewhere, too.
  [[nodiscard]] std::size_t memory() const { return pack + passes * packs() * pack + 2 * together * rows; }
};

/// Of symmetric matrices, q = scale · q̃.
/// @param load   in the coordinates q̃; null: given for each frequency, anywhere
/// @param free   each at most once, on one side of the diagonal
[[nodiscard]] BlockPlan block_plan(const DynamicMatrices& matrices, const Load* load, const Eigen::VectorXd& scale,
                                   const std::vector<FreeEntry>& free);

}  // namespace trivet::numerics
