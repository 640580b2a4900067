// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/response_series.h"

#include <Eigen/LU>

namespace trivet::numerics {
namespace {

/// Coefficients of (Z0 + Z1 τ + Z2 τ²)⁻¹ h.
Eigen::MatrixXcd series(const Eigen::MatrixXcd& Z0, const Eigen::MatrixXcd& Z1, const Eigen::MatrixXcd& Z2, const Eigen::VectorXcd& h,
                        int order) {
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(Z0);
  Eigen::MatrixXcd q(h.size(), order + 1);
  q.col(0) = lu.solve(h);
  q.col(0) += lu.solve(h - Z0 * q.col(0));
  for (int j = 1; j <= order; ++j) {
    Eigen::VectorXcd right = -(Z1 * q.col(j - 1));
    if (j > 1) right -= Z2 * q.col(j - 2);
    q.col(j) = lu.solve(right);
  }
  return q;
}

}  // namespace

Eigen::MatrixXcd response_series(const DynamicMatrices& given, const Eigen::VectorXcd& load, double centre, double radius, int order) {
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices m = scaled(given, d);
  const Eigen::MatrixXcd A = m.A.cast<Complex>(), B = m.B.cast<Complex>();
  const Eigen::MatrixXcd slope = radius * (Complex(0, 1) * B - 2 * centre * A);
  const Eigen::MatrixXcd curvature = -radius * radius * A;
  return d.asDiagonal() * series(m.at(centre), slope, curvature, d.asDiagonal() * load, order);
}

Eigen::MatrixXcd response_series_at_infinity(const DynamicMatrices& given, const Eigen::VectorXcd& load, double radius, int order) {
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices m = scaled(given, d);
  Eigen::MatrixXcd constant = -m.A.cast<Complex>();
  Eigen::MatrixXcd slope = Complex(0, radius) * m.B.cast<Complex>();
  Eigen::MatrixXcd curvature = radius * radius * m.complex_stiffness();
  // Without mass in a row, −A leaves it empty at s = 0; divided by s it is regular: s K + i B.
  for (Eigen::Index i = 0; i < m.size(); ++i)
    if (m.A.row(i).isZero(0)) {
      constant.row(i) = slope.row(i) / radius;
      slope.row(i) = curvature.row(i) / radius;
      curvature.row(i).setZero();
    }
  return d.asDiagonal() * series(constant, slope, curvature, d.asDiagonal() * load, order);
}

}  // namespace trivet::numerics
