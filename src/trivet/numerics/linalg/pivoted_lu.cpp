// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/decompositions.h"

#include <Eigen/LU>

#include "trivet/numerics/linalg/up_to_twelve.h"

namespace trivet::numerics {

template <typename Scalar>
struct PivotedLu<Scalar>::Factors {
  Eigen::PartialPivLU<Matrix> lu;
};

template <typename Scalar>
PivotedLu<Scalar>::PivotedLu(const Matrix& A)
    : factors_(std::make_shared<const Factors>(Factors{Eigen::PartialPivLU<Matrix>(A)})) {}

template <typename Scalar>
typename PivotedLu<Scalar>::Matrix PivotedLu<Scalar>::solve(const Matrix& B) const {
  return factors_->lu.solve(B);
}

template <typename Scalar>
typename PivotedLu<Scalar>::Vector PivotedLu<Scalar>::solve(const Vector& b) const {
  return factors_->lu.solve(b);
}

template <typename Scalar>
typename PivotedLu<Scalar>::Vector PivotedLu<Scalar>::pivots() const {
  return factors_->lu.matrixLU().diagonal();
}

template <typename Scalar>
Scalar PivotedLu<Scalar>::determinant() const {
  return factors_->lu.determinant();
}

template <typename Scalar>
double PivotedLu<Scalar>::smallest_pivot() const {
  return factors_->lu.matrixLU().diagonal().cwiseAbs().minCoeff();
}

template <typename Scalar>
double PivotedLu<Scalar>::reciprocal_condition() const {
  // The estimate of Eigen divides by the pivots.
  if ((factors_->lu.matrixLU().diagonal().array() == Scalar(0)).any()) return 0;
  return factors_->lu.rcond();
}

template class PivotedLu<double>;
template class PivotedLu<std::complex<double>>;

template <typename Matrix, typename Right>
Right lu_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B) {
  return Eigen::PartialPivLU<Matrix>(A.derived()).solve(B.derived());
}

template <typename Matrix>
Matrix inverse(const Eigen::PlainObjectBase<Matrix>& A) {
  return A.derived().inverse();
}

namespace {
template <typename Matrix>
using Plain = const Eigen::PlainObjectBase<Matrix>&;
template <typename Scalar>
using Square = Eigen::Matrix<Scalar, 6, 6>;
template <typename Scalar>
using ByRows = Eigen::Matrix<Scalar, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Complex = std::complex<double>;
}  // namespace

template Eigen::MatrixXd lu_solution(Plain<Eigen::MatrixXd>, Plain<Eigen::MatrixXd>);
template Eigen::VectorXcd lu_solution(Plain<Eigen::MatrixXcd>, Plain<Eigen::VectorXcd>);
template ExtendedVector lu_solution(Plain<ExtendedMatrix>, Plain<ExtendedVector>);
template Eigen::Vector3d lu_solution(Plain<Eigen::Matrix3d>, Plain<Eigen::Vector3d>);
template Vector6 lu_solution(Plain<Square<double>>, Plain<Vector6>);
template UpToTwelve<double> lu_solution(Plain<UpToTwelve<double>>, Plain<UpToTwelve<double>>);
template UpToTwelve<Complex> lu_solution(Plain<UpToTwelve<Complex>>, Plain<UpToTwelve<Complex>>);
template Square<double> lu_solution(Plain<ByRows<double>>, Plain<Square<double>>);
template Square<Complex> lu_solution(Plain<ByRows<Complex>>, Plain<Square<Complex>>);
template Square<long double> lu_solution(Plain<ByRows<long double>>, Plain<Square<long double>>);
template Eigen::Matrix3d inverse(Plain<Eigen::Matrix3d>);
template Square<double> inverse(Plain<Square<double>>);
template Eigen::MatrixXcd inverse(Plain<Eigen::MatrixXcd>);

}  // namespace trivet::numerics
