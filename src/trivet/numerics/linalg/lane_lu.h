// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "trivet/numerics/lanes/line_memory.h"

namespace trivet::numerics {

/// Solver of A x = b by LU with partial pivoting, with the best instructions of this processor, for matrices
/// of up to a few hundred rows. Solutions of a singular A are not finite or, by round-off, huge.
class LaneLu {
 public:
  explicit LaneLu(const Eigen::MatrixXd& A);

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  /// −1, 0 or 1.
  [[nodiscard]] int determinant_sign() const;

 private:
  Eigen::Index rows_, stride_;
  LineMemory factors_;  ///< columns, `stride_` numbers apart: L without its unit diagonal, and U
  std::vector<std::int32_t> pivots_;
};

}  // namespace trivet::numerics
