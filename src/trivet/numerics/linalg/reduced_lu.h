// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "trivet/numerics/linalg/lane_lu.h"

namespace trivet::numerics {

/// Solver of A x = b that first removes unknowns on which no other equation depends: columns that are zero but for the
/// diagonal and, of a bordered matrix, the last row. What is left is factored by LaneLu. Laws that do not act over a
/// motion, such as stops that it does not touch, leave such columns.
class ReducedLu {
 public:
  enum class Border { none, last_row };
  ReducedLu(const Eigen::MatrixXd& A, Border border);

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// −1, 0 or 1.
  [[nodiscard]] int determinant_sign() const;
  /// Number of unknowns that are factored.
  [[nodiscard]] Eigen::Index left() const { return static_cast<Eigen::Index>(kept_.size()); }

 private:
  /// @param unknowns  those that are removed, and the others
  ReducedLu(const Eigen::MatrixXd& A, Border border,
            std::pair<std::vector<Eigen::Index>, std::vector<Eigen::Index>> unknowns);
  [[nodiscard]] Eigen::MatrixXd reduced(const Eigen::MatrixXd& A, Border border);

  std::vector<Eigen::Index> removed_, kept_;  ///< the last one is kept
  Eigen::VectorXd diagonal_;                  ///< of the removed ones
  Eigen::RowVectorXd border_;                 ///< their entries in the last row over the diagonal; 0 without a border
  Eigen::MatrixXd by_kept_;                   ///< equations of the removed × kept unknowns
  LaneLu factors_;
};

}  // namespace trivet::numerics
