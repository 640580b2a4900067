// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace trivet::numerics {

/// Coefficients of a real motion of period 2π in its phase φ: x = c_0 + Σ_k (c_{2k−1} cos kφ + c_{2k} sin kφ), k = 1 …
/// harmonics. Its complex amplitude at harmonic k is c_{2k−1} − i c_{2k}.
[[nodiscard]] constexpr Eigen::Index coefficient_count(Eigen::Index harmonics) { return 2 * harmonics + 1; }

/// 1, cos φ, sin φ, cos 2φ, …: the value of a motion is this row times its coefficients.
inline void set_fourier_row(Eigen::Index harmonics, double phase, Eigen::RowVectorXd& row) {
  row.resize(coefficient_count(harmonics));
  const double c = std::cos(phase), s = std::sin(phase);
  row(0) = 1;
  double ck = 1, sk = 0;
  for (Eigen::Index k = 1; k <= harmonics; ++k) {
    const double next = ck * c - sk * s;
    sk = sk * c + ck * s;
    ck = next;
    row(2 * k - 1) = ck;
    row(2 * k) = sk;
  }
}
[[nodiscard]] inline Eigen::RowVectorXd fourier_row(Eigen::Index harmonics, double phase) {
  Eigen::RowVectorXd row;
  set_fourier_row(harmonics, phase, row);
  return row;
}

/// The value of a motion at a phase.
[[nodiscard]] inline double motion_at(Eigen::Index harmonics, double phase, const Eigen::VectorXd& coefficients) {
  const double c = std::cos(phase), s = std::sin(phase);
  double sum = coefficients(0), ck = 1, sk = 0;
  for (Eigen::Index k = 1; k <= harmonics; ++k) {
    const double next = ck * c - sk * s;
    sk = sk * c + ck * s;
    ck = next;
    sum += ck * coefficients(2 * k - 1) + sk * coefficients(2 * k);
  }
  return sum;
}

/// Coefficients of dx/dφ.
[[nodiscard]] inline Eigen::VectorXd phase_derivative(const Eigen::VectorXd& coefficients) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(coefficients.size());
  for (Eigen::Index k = 1; 2 * k < coefficients.size(); ++k) {
    result(2 * k - 1) = static_cast<double>(k) * coefficients(2 * k);
    result(2 * k) = -static_cast<double>(k) * coefficients(2 * k - 1);
  }
  return result;
}
/// The same column by column.
[[nodiscard]] inline Eigen::MatrixXd phase_derivatives(const Eigen::MatrixXd& coefficients) {
  Eigen::MatrixXd result(coefficients.rows(), coefficients.cols());
  for (Eigen::Index j = 0; j < coefficients.cols(); ++j) result.col(j) = phase_derivative(coefficients.col(j));
  return result;
}

}  // namespace trivet::numerics
