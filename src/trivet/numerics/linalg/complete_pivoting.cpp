// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/decompositions.h"

#include <cassert>

#include <Eigen/LU>

namespace trivet::numerics {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

bool is_regular(const Matrix6& A) { return Eigen::FullPivLU<Matrix6>(A).isInvertible(); }

bool is_regular(const Eigen::MatrixXd& A, double share) {
  assert(A.rows() == A.cols() && share >= 0 && share < 1);
  return Eigen::FullPivLU<Eigen::MatrixXd>(A).setThreshold(share).isInvertible();
}

Vector6 completely_pivoted_solution(const Matrix6& A, const Vector6& b) {
  return Eigen::FullPivLU<Matrix6>(A).solve(b);
}

Matrix6 completely_pivoted_inverse(const Matrix6& A) { return Eigen::FullPivLU<Matrix6>(A).inverse(); }

}  // namespace trivet::numerics
