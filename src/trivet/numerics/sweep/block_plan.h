// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/linalg/symmetric_entries.h"
#include "trivet/numerics/sweep/block_elimination.h"

namespace trivet::numerics {

/// Plan of LDLᵀ of K + iK_loss + iωB − ω²A by blocks in flat arrays: the steps for each frequency, without searches.
/// Rows are in elimination order.
struct BlockPlan {
  /// A block of the matrix, later of L: on the diagonal its packed lower triangle, else row by row.
  struct Block {
    int rows = 0, columns = 0;
    bool diagonal = false, has_A = false, has_B = false, has_K = false, has_loss = false;
    std::size_t values = 0;  ///< position in `values` of its entries of K, K_loss, B, A, as many of these as it has
    bool kept = false;       ///< L is kept; else used once and then replaced by the far smaller given block
    std::size_t place = 0;   ///< position among the factors, if kept
    std::size_t free_first = 0, free_end = 0;  ///< in `free`
    [[nodiscard]] bool has_free() const { return free_end > free_first; }
    [[nodiscard]] bool is_filled() const {
      return !(has_A || has_B || has_K || has_loss || has_free());
    }  ///< filled by the elimination only
    [[nodiscard]] int entries() const { return diagonal ? rows * (rows + 1) / 2 : rows * columns; }
  };
  /// A block below the diagonal of a column; those of one column are consecutive.
  struct Below {
    int block = 0;
    std::size_t row = 0;    ///< first row
    bool first = false;     ///< kept, and not yet updated
    std::size_t place = 0;  ///< position among all blocks below in this column
  };
  /// target −= left D rightᵀ
  struct Update {
    int target = 0;                   ///< in `blocks`
    std::size_t left = 0, right = 0;  ///< in `below`
    bool first = false;               ///< the target must be assembled first
  };
  struct Column {
    int size = 0, diagonal = 0;
    std::size_t row = 0;
    bool first = false;   ///< its diagonal is not yet updated
    bool loaded = false;  ///< its right side may be nonzero
    std::size_t below_first = 0, below_end = 0, update_first = 0, update_end = 0;
  };
  struct Free {
    std::size_t entry = 0;   ///< within the block
    std::size_t number = 0;  ///< index of the free entry
    double scale = 1;        ///< factor of the added value
    std::size_t row = 0, column = 0;
  };
  struct LoadRow {
    std::size_t row = 0;
    std::complex<double> value;
  };
  struct Term {
    LoadTerm given;
    std::vector<LoadRow> rows;          ///< nonzero rows of `given`, in elimination order
    std::complex<double> weighted = 0;  ///< wᵀ times `given`
  };
  /// An entry of the whole matrix with all its values, for residuals.
  struct Entry {
    std::size_t column = 0;
    double A = 0, B = 0, K = 0, loss = 0;
    int free = -1;  ///< index in `free`; −1: none
  };

  std::size_t rows = 0, factors = 0, widest = 0;  ///< `widest`: most entries below one column
  std::vector<Column> columns;
  std::vector<Block> blocks;
  std::vector<Below> below;
  std::vector<Update> updates;
  std::vector<Free> free;
  std::vector<double> values;
  std::vector<Term> load;
  std::vector<std::size_t> entry_first;  ///< start of each row in `entries`, and the end
  std::vector<Entry> entries;
  std::vector<std::size_t> large_rows;  ///< rows with the largest sum in one of the matrices
  std::vector<std::size_t> given_row;   ///< row of the given matrix for each row
  std::vector<double> scale;            ///< factor of the solution of row i
  /// w and wᵀA …, for the residual along one fixed direction w with ½ ≤ |w_i| ≤ 1.
  std::vector<double> weight, weighted_A, weighted_B, weighted_K, weighted_loss;
  bool given_load = false;  ///< the right side is given for each frequency
  double multiply_adds = 0;

  static constexpr int passes = 2;  ///< packs of frequencies that are solved together
  static constexpr int together =
      64;  ///< frequencies with solutions written together, in whole cache lines of each plane
  static constexpr std::size_t pack = 16;  ///< numbers in a complex pack of the widest lanes
  /// Complex packs for one pass, in addition to its solutions.
  [[nodiscard]] std::size_t packs() const {
    return factors + 2 * widest + (given_load ? 2 : 1) * rows + load.size() + free.size();
  }
  /// Numbers that a solver needs; not 0 even without rows, because empty arrays need an address.
  [[nodiscard]] std::size_t memory() const { return pack + passes * packs() * pack + 2 * std::size_t{together} * rows; }
};

/// Plan for symmetric matrices, q = scale · q̃.
/// @param load   in the coordinates q̃; null: given for each frequency, in any row
/// @param free   each at most once, on one side of the diagonal
[[nodiscard]] BlockPlan block_plan(const DynamicMatrices& matrices, const Load* load, const Eigen::VectorXd& scale,
                                   const std::vector<FreeEntry>& free);

}  // namespace trivet::numerics
