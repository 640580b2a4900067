// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/eigenvalues.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cassert>
#include <limits>
#include <type_traits>

#include "trivet/numerics/linalg/lapack.h"
#include "trivet/numerics/linalg/up_to_twelve.h"

namespace trivet::numerics {
namespace {
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;
template <typename Matrix>
using Plain = const Eigen::PlainObjectBase<Matrix>&;
/// One compiled version for all fixed sizes.
template <typename Matrix>
using Computed = std::conditional_t<Matrix::RowsAtCompileTime == Eigen::Dynamic, Matrix, UpToTwelve<double>>;

template <typename Matrix>
SymmetricEigen<Matrix> solved(const Matrix& S, bool with_vectors) {
  assert(S.rows() == S.cols());
  if (!S.allFinite())  // an eigensolver may not return from NaN
    return {Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1>::Constant(S.rows(),
                                                                          std::numeric_limits<double>::quiet_NaN()),
            S, false};
  if constexpr (std::is_same_v<Matrix, Eigen::MatrixXd>)
    if (S.rows() > lapack::least_size && lapack::is_available()) {
      SymmetricEigen<Matrix> found;
      found.vectors = S;
      found.converged = lapack::symmetric_eigen(found.vectors, found.values, with_vectors);
      return found;
    }
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(
      S, with_vectors ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
  SymmetricEigen<Matrix> found{solver.eigenvalues(), {}, solver.info() == Eigen::Success};
  if (with_vectors) found.vectors = solver.eigenvectors();
  return found;
}
}  // namespace

template <typename Matrix>
SymmetricEigen<Matrix> symmetric_eigen(const Eigen::PlainObjectBase<Matrix>& S) {
  const auto found = solved(Computed<Matrix>(S.derived()), true);
  return {found.values, found.vectors, found.converged};
}

template <typename Matrix>
SymmetricEigen<Matrix> symmetric_eigen(const Eigen::PlainObjectBase<Matrix>& S,
                                       const Eigen::PlainObjectBase<Matrix>& P) {
  assert(S.rows() == P.rows() && S.cols() == P.cols());
  const Eigen::LLT<Computed<Matrix>> cholesky(P.derived());
  const auto L = cholesky.matrixL();
  const Computed<Matrix> half = L.solve(Computed<Matrix>(S.derived()));
  Computed<Matrix> reduced = L.solve(half.transpose());
  reduced = (0.5 * (reduced + reduced.transpose())).eval();
  const auto found = solved(reduced, true);
  return {found.values, cholesky.matrixU().solve(found.vectors), found.converged};
}

template <typename Matrix>
Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> symmetric_eigenvalues(const Eigen::PlainObjectBase<Matrix>& S) {
  return solved(Computed<Matrix>(S.derived()), false).values;
}

template SymmetricEigen<Eigen::MatrixXd> symmetric_eigen(Plain<Eigen::MatrixXd>);
template SymmetricEigen<Eigen::Matrix2d> symmetric_eigen(Plain<Eigen::Matrix2d>);
template SymmetricEigen<Eigen::Matrix3d> symmetric_eigen(Plain<Eigen::Matrix3d>);
template SymmetricEigen<Matrix6> symmetric_eigen(Plain<Matrix6>);
template SymmetricEigen<Matrix12> symmetric_eigen(Plain<Matrix12>);
template SymmetricEigen<Eigen::Matrix2d> symmetric_eigen(Plain<Eigen::Matrix2d>, Plain<Eigen::Matrix2d>);
template SymmetricEigen<Eigen::MatrixXd> symmetric_eigen(Plain<Eigen::MatrixXd>, Plain<Eigen::MatrixXd>);
template Eigen::VectorXd symmetric_eigenvalues(Plain<Eigen::MatrixXd>);
template Eigen::VectorXd symmetric_eigenvalues(Plain<Eigen::MatrixXcd>);
template Eigen::Matrix<double, 6, 1> symmetric_eigenvalues(Plain<Matrix6>);
template Eigen::Matrix<double, 12, 1> symmetric_eigenvalues(Plain<Matrix12>);

}  // namespace trivet::numerics
