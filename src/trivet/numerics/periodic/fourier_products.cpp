// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/fourier_products.h"

#include <cmath>
#include <complex>

#include "trivet/foundation/constants.h"
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

Eigen::VectorXd product(const Eigen::VectorXd& spectrum, const Eigen::VectorXd& motion, Index harmonics) {
  Eigen::VectorXd result = motion(0) * spectrum.head(coefficient_count(harmonics));
  for (Index l = 1; 2 * l < motion.size(); ++l) {
    const double a = motion(2 * l - 1), b = motion(2 * l);
    result(0) += a * spectrum(2 * l - 1) + b * spectrum(2 * l);
    const double half_a = a / 2, half_b = b / 2;
    for (Index k = 1; k <= harmonics; ++k) {
      const Index apart = k - l, sum = k + l;
      const double cosine = apart == 0 ? spectrum(0) : spectrum(2 * std::abs(apart) - 1),
                   sine = apart == 0 ? 0
          : apart > 0                ? spectrum(2 * apart)
                                     : -spectrum(-2 * apart);
      result(2 * k - 1) += half_a * (cosine + spectrum(2 * sum - 1)) + half_b * (spectrum(2 * sum) - sine);
      result(2 * k) += half_a * (spectrum(2 * sum) + sine) + half_b * (cosine - spectrum(2 * sum - 1));
    }
  }
  return result;
}

void add_stretch(double from, double to, double constant, Eigen::VectorXd& spectrum) {
  const double weight = constant / (foundation::two_pi / 2);
  const std::complex<double> at_from = std::polar(1.0, from), at_to = std::polar(1.0, to);
  spectrum(0) += weight * (to - from);
  std::complex<double> a = 1, b = 1;
  for (Index k = 1; 2 * k < spectrum.size(); ++k) {
    a = {a.real() * at_from.real() - a.imag() * at_from.imag(), a.real() * at_from.imag() + a.imag() * at_from.real()};
    b = {b.real() * at_to.real() - b.imag() * at_to.imag(), b.real() * at_to.imag() + b.imag() * at_to.real()};
    const double share = weight / static_cast<double>(k);
    spectrum(2 * k - 1) += share * (b.imag() - a.imag());
    spectrum(2 * k) += share * (a.real() - b.real());
  }
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
