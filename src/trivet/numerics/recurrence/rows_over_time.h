// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/lanes/line_memory.h"

namespace trivet::numerics {

/// What a block of values of one row contains.
struct RowBlock {
  double largest = 0, smallest = 0;
  double bend = 0;     ///< largest |y(i) − 2y(i − 1) + y(i − 2)| of the values i of this block
  double squares = 0;  ///< Σ y²
};

/// Products of a constant matrix with the states of successive times, block by block. Results are kept by rows of
/// time; the first two values of all count as preceded by equal ones.
class RowsOverTime {
 public:
  /// @param rows  of results × states
  RowsOverTime(const Eigen::MatrixXd& rows, Eigen::Index most_times);

  /// rows · states of the next times.
  void evaluate(const Eigen::Ref<const Eigen::MatrixXd>& states);
  /// Values of one row at these times, copied to `to`.
  void copy_row(Eigen::Index row, Eigen::Ref<Eigen::VectorXd> to) const;
  /// The same block of one row in numbers.
  [[nodiscard]] RowBlock block(Eigen::Index row) const;

 private:
  [[nodiscard]] double* values(Eigen::Index group) const;

  Eigen::Index rows_, groups_, most_times_, times_ = 0;
  bool begun_ = false;
  std::vector<Eigen::Index> used_;  ///< states that any row contains
  LineMemory coefficients_;         ///< per group and used state: one lane per row
  LineMemory values_;               ///< per group and time: one lane per row
  LineMemory summary_;              ///< per group: largest, smallest, bend, squares, the last value and the one before
};

}  // namespace trivet::numerics
