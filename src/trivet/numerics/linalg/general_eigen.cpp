// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/eigenvalues.h"

#include <cassert>
#include <limits>

#include <Eigen/Eigenvalues>

#include "trivet/numerics/linalg/lapack.h"

namespace trivet::numerics {
namespace {

template <typename Solver, typename Matrix>
GeneralEigen eigen_by(const Matrix& A, bool with_vectors) {
  assert(A.rows() == A.cols());
  if (!A.allFinite())  // LAPACK may not return from NaN
    return {Eigen::VectorXcd::Constant(A.rows(), std::numeric_limits<double>::quiet_NaN()), {}, false};
  if (A.rows() > lapack::least_size && lapack::is_available()) {
    GeneralEigen found;
    found.converged = lapack::general_eigen(A, found.values, with_vectors ? &found.vectors : nullptr);
    if (!found.converged) found.vectors.resize(0, 0);
    return found;
  }
  const Solver solver(A, with_vectors);
  const bool converged = solver.info() == Eigen::Success;
  return {solver.eigenvalues(),
          with_vectors && converged ? Eigen::MatrixXcd(solver.eigenvectors()) : Eigen::MatrixXcd(), converged};
}

}  // namespace

GeneralEigen general_eigen(const Eigen::MatrixXd& A) { return eigen_by<Eigen::EigenSolver<Eigen::MatrixXd>>(A, true); }
GeneralEigen general_eigen(const Eigen::MatrixXcd& A) {
  return eigen_by<Eigen::ComplexEigenSolver<Eigen::MatrixXcd>>(A, true);
}
GeneralEigen general_eigenvalues(const Eigen::MatrixXd& A) {
  return eigen_by<Eigen::EigenSolver<Eigen::MatrixXd>>(A, false);
}
GeneralEigen general_eigenvalues(const Eigen::MatrixXcd& A) {
  return eigen_by<Eigen::ComplexEigenSolver<Eigen::MatrixXcd>>(A, false);
}

}  // namespace trivet::numerics
