// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/cholesky.h"

#include <Eigen/Cholesky>

namespace trivet::numerics {

template <typename Matrix, typename Right>
Right cholesky_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B) {
  return Eigen::LLT<Matrix>(A.derived()).solve(B.derived());
}

template <typename Matrix, typename Right>
Right ldlt_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B) {
  return Eigen::LDLT<Matrix>(A.derived()).solve(B.derived());
}

Eigen::VectorXd ldlt_pivots(const Eigen::MatrixXd& A) { return Eigen::LDLT<Eigen::MatrixXd>(A).vectorD(); }

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
