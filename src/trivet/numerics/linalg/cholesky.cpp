// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cassert>

#include "trivet/foundation/constants.h"

namespace trivet::numerics {

template <typename Matrix, typename Right>
Right cholesky_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B) {
  assert(A.rows() == A.cols() && A.rows() == B.rows());
  return Eigen::LLT<Matrix>(A.derived()).solve(B.derived());
}

template <typename Matrix, typename Right>
Right ldlt_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B) {
  return Eigen::LDLT<Matrix>(A.derived()).solve(B.derived());
}

Eigen::VectorXd ldlt_pivots(const Eigen::MatrixXd& A) { return Eigen::LDLT<Eigen::MatrixXd>(A).vectorD(); }

namespace {

/// True if A = L Lᵀ exists: by sparse factors where most entries of a large matrix are zero.
bool has_cholesky_factor(const Eigen::MatrixXd& A) {
  constexpr Eigen::Index least_sparse = 300;
  constexpr double most_filled = 0.1;
  if (A.rows() >= least_sparse &&
      static_cast<double>((A.array() != 0).count()) < most_filled * static_cast<double>(A.size()))
    return Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(A.sparseView()).info() == Eigen::Success;
  return Eigen::LLT<Eigen::MatrixXd>(A).info() == Eigen::Success;
}

}  // namespace

bool is_positive_definite(const Eigen::MatrixXd& A) {
  assert(A.rows() == A.cols());
  if (!A.allFinite() || !(A.diagonal().minCoeff() > 0)) return false;
  const Eigen::VectorXd d = A.diagonal().cwiseSqrt().cwiseInverse();
  Eigen::MatrixXd shifted = d.asDiagonal() * A * d.asDiagonal();
  shifted.diagonal().array() -= 8 * static_cast<double>(A.rows()) * foundation::epsilon;
  return has_cholesky_factor(shifted);
}

bool is_positive_semidefinite(const Eigen::MatrixXd& A) {
  assert(A.rows() == A.cols());
  const Eigen::VectorXd diagonal = A.diagonal();
  if (!A.allFinite() || !(diagonal.size() == 0 || diagonal.minCoeff() >= 0)) return false;
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    if (diagonal(i) == 0 && !(A.row(i).head(i).isZero(0) && A.col(i).tail(A.rows() - i).isZero(0))) return false;
  const Eigen::VectorXd d = (diagonal.array() > 0).select(diagonal.array().rsqrt(), 0.0);
  Eigen::MatrixXd shifted = d.asDiagonal() * A * d.asDiagonal();
  const double round_off = 64 * static_cast<double>(A.rows()) * foundation::epsilon;
  shifted.diagonal().array() += (diagonal.array() > 0).select(round_off, Eigen::ArrayXd::Ones(A.rows()));
  return has_cholesky_factor(shifted);
}

namespace {
template <typename Matrix>
using Plain = const Eigen::PlainObjectBase<Matrix>&;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using SixByTwelve = Eigen::Matrix<double, 6, 12, Eigen::RowMajor>;
}  // namespace

template Eigen::MatrixXd cholesky_solution(Plain<Eigen::MatrixXd>, Plain<Eigen::MatrixXd>);
template Eigen::VectorXd cholesky_solution(Plain<Eigen::MatrixXd>, Plain<Eigen::VectorXd>);
template Eigen::Vector3d cholesky_solution(Plain<Eigen::Matrix3d>, Plain<Eigen::Vector3d>);
template Eigen::MatrixXd ldlt_solution(Plain<Eigen::MatrixXd>, Plain<Eigen::MatrixXd>);
template Eigen::VectorXd ldlt_solution(Plain<Eigen::MatrixXd>, Plain<Eigen::VectorXd>);
template SixByTwelve ldlt_solution(Plain<Matrix6>, Plain<SixByTwelve>);

}  // namespace trivet::numerics
