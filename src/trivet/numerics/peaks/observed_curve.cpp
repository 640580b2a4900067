// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/observed_curve.h"

#include <cmath>

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"

namespace trivet::numerics {
namespace {

Eigen::RowVectorXd possible(const CurveTerms& terms, const Eigen::MatrixXd& sizes, const Eigen::RowVectorXd& omega) {
  const auto reach = [&](const auto& on) -> Eigen::RowVectorXd {
    return on.head(sizes.rows()).cwiseAbs().transpose() * sizes;
  };
  return reach(terms.on_displacement) + reach(terms.on_velocity).cwiseProduct(omega) +
      reach(terms.on_acceleration).cwiseProduct(omega.cwiseAbs2());
}

}  // namespace

ObservedCurve observed_curve(const ObservedRow& row) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(row.on_displacement.size());
  return {{row.on_displacement.cast<std::complex<double>>(), row.on_velocity.size() > 0 ? row.on_velocity : none, none},
          {},
          row.derivative};
}

Eigen::RowVectorXcd weighted(const CurveTerms& terms, const Eigen::MatrixXcd& x, const Eigen::RowVectorXcd& omega) {
  const Eigen::Index n = x.rows();
  Eigen::RowVectorXcd y = terms.on_displacement.head(n).transpose() * x;
  if (!terms.on_velocity.head(n).isZero(0))
    y += Complex(0, 1) * (terms.on_velocity.head(n).transpose().cast<Complex>() * x).cwiseProduct(omega);
  if (!terms.on_acceleration.head(n).isZero(0))
    y -= (terms.on_acceleration.head(n).transpose().cast<Complex>() * x).cwiseProduct(omega.cwiseProduct(omega));
  return y;
}

Eigen::RowVectorXcd curve_values(const ObservedCurve& curve, const Eigen::MatrixXcd& q, const Eigen::MatrixXcd& given,
                                 const Eigen::RowVectorXcd& omega) {
  Eigen::RowVectorXcd y = weighted(curve.of_response, q, omega);
  if (!curve.of_given.empty() && given.size() > 0) y += weighted(curve.of_given, given, omega);
  for (Eigen::Index i = 0; i < y.size(); ++i)
    y(i) *= integer_power(std::complex<double>(0, 1) * omega(i), curve.derivative);
  return y;
}

Eigen::RowVectorXd possible_amplitudes(const ObservedCurve& curve, const Eigen::MatrixXd& q,
                                       const Eigen::MatrixXd& given, const Eigen::RowVectorXd& omega) {
  Eigen::RowVectorXd y = possible(curve.of_response, q, omega);
  if (!curve.of_given.empty() && given.size() > 0) y += possible(curve.of_given, given, omega);
  return y.cwiseProduct(omega.array().pow(curve.derivative).matrix());
}

}  // namespace trivet::numerics
