// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>

namespace trivet::numerics {

using ExtendedMatrix = Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, Eigen::Dynamic>;
using ExtendedVector = Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, 1>;

/// Solver of A X = B by LU with partial pivoting that keeps the factors for several right sides. Scalar: double or
/// std::complex<double>. A singular A shows in its pivots and its condition number; its solutions are not finite.
template <typename Scalar>
class PivotedLu {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  explicit PivotedLu(const Matrix& A);

  [[nodiscard]] Matrix solve(const Matrix& B) const;
  [[nodiscard]] Vector solve(const Vector& b) const;
  [[nodiscard]] Vector pivots() const;  ///< diagonal of U
  [[nodiscard]] Scalar determinant() const;
  [[nodiscard]] double smallest_pivot() const;        ///< by magnitude
  [[nodiscard]] double reciprocal_condition() const;  ///< 1/(‖A‖₁ ‖A⁻¹‖₁), estimated

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

extern template class PivotedLu<double>;
extern template class PivotedLu<std::complex<double>>;

/// Solution X of A X = B by LU with partial pivoting, of the type of B. Plain matrices of these types only: dynamic
/// (double with matrix, std::complex<double> and std::complex<long double> with vector); 3×3 and 6×6 with vector; up to
/// 12 rows (double, std::complex<double>); 6×6 by rows with 6×6 (these and long double). Another size or order of
/// entries may round differently.
template <typename Matrix, typename Right>
[[nodiscard]] Right lu_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B);

/// A⁻¹: 3×3 by cofactors, 6×6 and MatrixXcd by LU with partial pivoting.
template <typename Matrix>
[[nodiscard]] Matrix inverse(const Eigen::PlainObjectBase<Matrix>& A);

}  // namespace trivet::numerics
