// SPDX-License-Identifier: BSD-3-Clause
#include "support/lyapunov.h"

#include <Eigen/Eigenvalues>
#include <complex>

#include "trivet/foundation/invalid_input.h"

namespace trivet::test {

Eigen::MatrixXd lyapunov_covariance(const Eigen::MatrixXd& state, const Eigen::MatrixXd& intensity) {
  using Complex = std::complex<double>;
  if (state.rows() != state.cols() || intensity.rows() != state.rows() || intensity.cols() != state.rows())
    throw foundation::InvalidInput("covariance: the state matrix and the intensity must be square and of one size");
  const Eigen::ComplexSchur<Eigen::MatrixXcd> schur(state.cast<Complex>());
  if (schur.info() != Eigen::Success)
    throw foundation::NotComputable("the Schur form of the state matrix did not converge");
  const Eigen::MatrixXcd &T = schur.matrixT(), &U = schur.matrixU();
  const Eigen::Index n = T.rows();
  for (Eigen::Index i = 0; i < n; ++i)
    if (!(T(i, i).real() < 0))
      throw foundation::NotComputable(
          "a free motion does not decay: under white noise no stationary covariance exists");
  // T Y + Y Tᴴ = −Uᴴ Q U, solved from the last row and column backwards.
  Eigen::MatrixXcd Y = -(U.adjoint() * intensity.cast<Complex>() * U);
  for (Eigen::Index j = n - 1; j >= 0; --j) {
    if (j + 1 < n) Y.col(j) -= Y.rightCols(n - j - 1) * T.row(j).tail(n - j - 1).adjoint();
    for (Eigen::Index i = n - 1; i >= 0; --i) {
      if (i + 1 < n) Y(i, j) -= (T.row(i).tail(n - i - 1) * Y.col(j).tail(n - i - 1)).value();
      Y(i, j) /= T(i, i) + std::conj(T(j, j));
    }
  }
  const Eigen::MatrixXd P = (U * Y * U.adjoint()).real();
  return 0.5 * (P + P.transpose());
}

}  // namespace trivet::test
