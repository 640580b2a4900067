// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/decompositions.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>

namespace trivet::numerics {

RankedSolution ranked_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(A);
  return {decomposition.solve(B), decomposition.rank()};
}

Eigen::MatrixXd smallest_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return ranked_solution(A, B).X;
}

Eigen::VectorXd smallest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(A).solve(b);
}

Eigen::VectorXcd smallest_solution(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b) {
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXcd>(A).solve(b);
}

ExtendedRealMatrix pivoted_qr_solution(const ExtendedRealMatrix& A, const ExtendedRealMatrix& B) {
  return Eigen::ColPivHouseholderQR<ExtendedRealMatrix>(A).solve(B);
}

PivotedQr pivoted_qr(const Eigen::MatrixXd& A, double share) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  qr.setThreshold(share);
  const Eigen::Index m = std::min(A.rows(), A.cols());
  PivotedQr result;
  result.Q = qr.householderQ() * Eigen::MatrixXd::Identity(A.rows(), m);
  [[maybe_unused]] constexpr double of_reflections = 1e-10;  // some ε for each of up to some thousand rows
  assert((!A.allFinite() || (result.Q.transpose() * result.Q).isIdentity(of_reflections)) && "QᵀQ = 1");
  result.R = qr.matrixQR().topRows(m);
  result.P = qr.colsPermutation();
  result.rank = qr.rank();
  return result;
}

}  // namespace trivet::numerics
