// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Least-squares solution X of A X = B with the smallest norm, for any rank of A, by complete orthogonal decomposition.
struct RankedSolution {
  Eigen::MatrixXd X;
  Eigen::Index rank = 0;  ///< of A, beyond round-off
};
[[nodiscard]] RankedSolution ranked_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// The same without the rank.
[[nodiscard]] Eigen::MatrixXd smallest_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
[[nodiscard]] Eigen::VectorXd smallest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
[[nodiscard]] Eigen::VectorXcd smallest_solution(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b);

using ExtendedRealMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
/// Least-squares solution X of A X = B by QR with column pivoting, in extended precision; 0 for columns of A with
/// pivots of round-off.
[[nodiscard]] ExtendedRealMatrix pivoted_qr_solution(const ExtendedRealMatrix& A, const ExtendedRealMatrix& B);

/// A P = Q R with column pivoting; m is the smaller number of rows and columns of A.
struct PivotedQr {
  Eigen::MatrixXd Q;                           ///< rows × m, orthonormal columns
  Eigen::MatrixXd R;                           ///< m × columns, upper triangle; entries below it are meaningless
  Eigen::PermutationMatrix<Eigen::Dynamic> P;  ///< columns with the largest remainder first
  Eigen::Index rank = 0;                       ///< number of pivots above `share` of the largest one
};
[[nodiscard]] PivotedQr pivoted_qr(const Eigen::MatrixXd& A, double share);

}  // namespace trivet::numerics
