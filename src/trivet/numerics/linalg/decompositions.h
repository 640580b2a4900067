// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <memory>

namespace trivet::numerics {

/// Solution X of A X = B by A = L Lᵀ, of the type of B; A is symmetric positive definite, only its lower triangle is
/// read. Plain matrices only: MatrixXd with matrix or vector, Matrix3d with vector. Meaningless unless A is definite.
template <typename Matrix, typename Right>
[[nodiscard]] Right cholesky_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B);

/// Solution X of A X = B by Pᵀ L D Lᵀ P with diagonal pivoting; A is symmetric, definite or semidefinite, only its
/// lower triangle is read. Plain matrices only: MatrixXd with matrix or vector, 6×6 with 6×12 by rows.
template <typename Matrix, typename Right>
[[nodiscard]] Right ldlt_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B);

/// Diagonal of D in that factorisation: it has as many negative entries as A has negative eigenvalues (Sylvester).
[[nodiscard]] Eigen::VectorXd ldlt_pivots(const Eigen::MatrixXd& A);

/// True if A (symmetric, only its lower triangle is read) is positive definite, for coordinates scaled to a unit
/// diagonal by more than round-off.
[[nodiscard]] bool is_positive_definite(const Eigen::MatrixXd& A);

/// True if A (symmetric, only its lower triangle is read) has no negative eigenvalue beyond round-off, for coordinates
/// scaled to a unit diagonal.
[[nodiscard]] bool is_positive_semidefinite(const Eigen::MatrixXd& A);

/// Whether A is regular: by LU with complete pivoting, its smallest pivot exceeds round-off, or `share` of the largest
/// pivot.
[[nodiscard]] bool is_regular(const Eigen::Matrix<double, 6, 6>& A);
[[nodiscard]] bool is_regular(const Eigen::MatrixXd& A, double share);

/// Solution x of A x = b by LU with complete pivoting; if A is singular, one of the solutions or the best
/// approximation.
[[nodiscard]] Eigen::Matrix<double, 6, 1> completely_pivoted_solution(const Eigen::Matrix<double, 6, 6>& A,
                                                                      const Eigen::Matrix<double, 6, 1>& b);

/// A⁻¹ by LU with complete pivoting; meaningless unless A is regular.
[[nodiscard]] Eigen::Matrix<double, 6, 6> completely_pivoted_inverse(const Eigen::Matrix<double, 6, 6>& A);

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
