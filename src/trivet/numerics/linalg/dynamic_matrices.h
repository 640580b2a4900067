// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <vector>

namespace trivet::numerics {

using Complex = std::complex<double>;

/// Z(ω) = K + iK_loss + iωB − ω²A for ω > 0; all n × n, real. `symmetric` allows solvers to use the symmetry.
struct DynamicMatrices {
  Eigen::MatrixXd A;
  Eigen::MatrixXd B;
  Eigen::MatrixXd K;
  Eigen::MatrixXd K_loss;  ///< empty if there is no loss factor
  bool symmetric = true;
  std::vector<Eigen::Index> blocks =
      {};  ///< first row of each block of coordinates (a body), ascending from 0; empty: unknown

  [[nodiscard]] Eigen::Index size() const { return A.rows(); }
  [[nodiscard]] bool lossy() const { return K_loss.size() > 0; }
  [[nodiscard]] Eigen::MatrixXcd complex_stiffness() const {
    Eigen::MatrixXcd stiffness = K.cast<Complex>();
    if (lossy()) stiffness.imag() = K_loss;
    return stiffness;
  }
  [[nodiscard]] Eigen::MatrixXcd at(double omega) const {
    return complex_stiffness() + Complex(0, omega) * B.cast<Complex>() - omega * omega * A.cast<Complex>();
  }
};

/// Diagonal of D, D_ii = 1/√|A_ii|: D A D has a unit diagonal, so that metres and radians are comparable. 1 if A_ii is
/// 0.
[[nodiscard]] inline Eigen::VectorXd unit_scale(const Eigen::MatrixXd& A) {
  return A.diagonal().unaryExpr([](double a) { return a == 0 ? 1.0 : 1 / std::sqrt(std::abs(a)); });
}

/// Rows of A with mass; the others are internal coordinates of elements (a Maxwell branch) with damping and stiffness
/// only.
[[nodiscard]] std::vector<Eigen::Index> massive_rows(const Eigen::MatrixXd& A);

/// The rows 0 … n − 1 that are not in the ascending list `rows`.
[[nodiscard]] std::vector<Eigen::Index> rows_without(Eigen::Index n, const std::vector<Eigen::Index>& rows);

/// The scale of a system; a coordinate without mass is scaled so that its stiffness is the largest K_ii / A_ii of the
/// others.
[[nodiscard]] Eigen::VectorXd unit_scale(const DynamicMatrices& m);

/// The matrices in coordinates q̃, q = D q̃.
[[nodiscard]] inline DynamicMatrices scaled(const DynamicMatrices& m, const Eigen::VectorXd& d) {
  const auto apply = [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd { return d.asDiagonal() * x * d.asDiagonal(); };
  return {apply(m.A), apply(m.B), apply(m.K), m.lossy() ? apply(m.K_loss) : Eigen::MatrixXd(), m.symmetric, m.blocks};
}

}  // namespace trivet::numerics
