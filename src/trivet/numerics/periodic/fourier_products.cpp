// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/fourier_products.h"

#include <cmath>
#include <complex>

#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::numerics {

using Eigen::Index;

Eigen::MatrixXd product_matrix(const Eigen::VectorXd& spectrum, Index harmonics) {
  const auto c = [&](Index n) { return n == 0 ? spectrum(0) : spectrum(2 * std::abs(n) - 1); };
  const auto s = [&](Index n) { return n == 0 ? 0.0 : n > 0 ? spectrum(2 * n) : -spectrum(-2 * n); };
  Eigen::MatrixXd matrix(coefficient_count(harmonics), coefficient_count(harmonics));
  matrix(0, 0) = c(0) / 2;
  for (Index k = 1; k <= harmonics; ++k) {
    matrix(0, 2 * k - 1) = c(k) / 2;
    matrix(0, 2 * k) = s(k) / 2;
    matrix(2 * k - 1, 0) = c(k);
    matrix(2 * k, 0) = s(k);
    for (Index l = 1; l <= harmonics; ++l) {
      matrix(2 * k - 1, 2 * l - 1) = (c(k - l) + c(k + l)) / 2;
      matrix(2 * k, 2 * l - 1) = (s(k + l) + s(k - l)) / 2;
      matrix(2 * k - 1, 2 * l) = (s(k + l) - s(k - l)) / 2;
      matrix(2 * k, 2 * l) = (c(k - l) - c(k + l)) / 2;
    }
  }
  return matrix;
}

Eigen::MatrixXd on_motion(const Eigen::MatrixXd& on_rate) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(on_rate.rows(), on_rate.cols());
  for (Index k = 1; 2 * k < on_rate.cols(); ++k) {
    matrix.col(2 * k - 1) = -static_cast<double>(k) * on_rate.col(2 * k);
    matrix.col(2 * k) = static_cast<double>(k) * on_rate.col(2 * k - 1);
  }
  return matrix;
}

std::complex<double> exponential_coefficient(const Eigen::VectorXd& of, Index n) {
  if (n == 0) return of(0) / 2;
  const Index k = std::abs(n);
  const std::complex<double> half(of(2 * k - 1) / 2, -of(2 * k) / 2);
  return n > 0 ? half : std::conj(half);
}

}  // namespace trivet::numerics
