// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <complex>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/rational_fit.h"

namespace rational_fit_test {

using namespace trivet;
using Complex = std::complex<double>;

constexpr double fit_error = 1e-6;                   // that the fit is requested, at its samples
constexpr double between_samples = 100 * fit_error;  // resonances have few samples
constexpr double pole_error = 1e-4;                  // of the half-width, which the same samples show

/// Two curves with resonances at 3, 7 and 7.01 rad/s with different damping, one of them not conjugate-symmetric.
Eigen::VectorXcd curves(double w) {
  const Complex i(0, 1);
  const auto pole = [&](double natural, double ratio) {
    return 1.0 / (natural * natural - w * w + 2.0 * i * ratio * natural * w);
  };
  Eigen::VectorXcd y(2);
  y << 2.0 * pole(3, 1e-3) + 5.0 * pole(7, 1e-2), Complex(1, 2) * pole(7, 1e-2) - i * pole(7.01, 1e-4) * w;
  return y;
}

Eigen::MatrixXcd curves(const Eigen::VectorXd& x) {
  Eigen::MatrixXcd y(2, x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) y.col(k) = curves(x(k));
  return y;
}

numerics::RationalFit fit(const Eigen::VectorXd& x) {
  const Eigen::MatrixXcd y = curves(x);
  return numerics::rational_fit(x, y, y.cwiseAbs(), fit_error);
}

Eigen::VectorXd samples() {
  Eigen::VectorXd x(27);
  x << 0, 0.5, 1, 1.8, 2.5, 2.99, 2.997, 3, 3.003, 3.01, 3.5, 4.2, 5, 6, 6.5, 6.9, 6.93, 7, 7.0093, 7.01, 7.0107, 7.07,
      7.2, 7.6, 8.5, 9.2, 10;
  return x;
}

TEST(RationalFit, FollowsRationalFunctionsBetweenFewSamples) {
  const numerics::RationalFit found = fit(samples());
  EXPECT_LE(found.error, fit_error);
  EXPECT_LE(found.nodes.size(), 9) << "six poles, of which three are far from the axis, and what the numerators need";
  const Eigen::VectorXd dense = Eigen::VectorXd::LinSpaced(20001, 0, 10);
  const Eigen::MatrixXcd truth = curves(dense);
  EXPECT_LE(((found.at(dense) - truth).array().abs() / truth.array().abs()).maxCoeff(), between_samples);
}

/// So many functions that their combinations choose nodes and weights: all mixtures of the two curves.
TEST(RationalFit, OfManyFunctionsFollowsEachOfThem) {
  const Eigen::Index many = 3 * numerics::many_functions;
  Eigen::MatrixXcd mixture(many, 2);
  for (Eigen::Index f = 0; f < many; ++f) {
    const double turn = 0.7 * static_cast<double>(f);
    mixture.row(f) << std::polar(1 + std::cos(turn), turn), std::polar(std::exp(3 * std::sin(turn)), -2 * turn);
  }
  const Eigen::VectorXd x = samples(), dense = Eigen::VectorXd::LinSpaced(20001, 0, 10);
  const Eigen::MatrixXcd y = mixture * curves(x), truth = mixture * curves(dense);
  const numerics::RationalFit found = numerics::rational_fit(x, y, y.cwiseAbs(), fit_error),
                              resumed = numerics::rational_fit(x, y, y.cwiseAbs(), fit_error, found.nodes.head(4));
  for (const numerics::RationalFit& one : {found, resumed}) {
    EXPECT_LE(one.error, fit_error);
    EXPECT_LE(one.nodes.size(), 11);
    EXPECT_LE(((one.at(dense) - truth).array().abs() / truth.array().abs()).maxCoeff(), between_samples);
  }
  EXPECT_EQ(resumed.nodes.head(4), found.nodes.head(4));
}

TEST(RationalFit, PassesThroughItsNodes) {
  const numerics::RationalFit found = fit(samples());
  EXPECT_EQ(found.at(found.nodes), found.values);
  EXPECT_EQ(found.values, curves(found.nodes));
}

TEST(RationalFit, FindsThePolesNearTheAxis) {
  const Eigen::VectorXcd poles = fit(samples()).poles();
  for (const auto& [natural, ratio] : {std::pair{3.0, 1e-3}, std::pair{7.0, 1e-2}, std::pair{7.01, 1e-4}}) {
    const Complex pole(natural * std::sqrt(1 - ratio * ratio), natural * ratio);  // of e^{iωt}: Im > 0
    EXPECT_LE((poles.array() - pole).abs().minCoeff(), pole_error * natural * ratio) << natural;
  }
}

TEST(RationalFit, IsExactForConstants) {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(5, 0, 4);
  const Eigen::MatrixXcd constant = Eigen::MatrixXcd::Constant(1, 5, Complex(2, -1));
  const numerics::RationalFit found = numerics::rational_fit(x, constant, constant.cwiseAbs(), fit_error);
  EXPECT_EQ(found.error, 0);
  EXPECT_EQ(found.at(Eigen::VectorXd::Constant(1, 2.2))(0), Complex(2, -1));
}

TEST(RationalFit, RejectsInconsistentSizes) {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(5, 0, 4);
  const Eigen::MatrixXcd y = Eigen::MatrixXcd::Ones(1, 5);
  EXPECT_THROW(static_cast<void>(numerics::rational_fit(x, y, Eigen::MatrixXd::Zero(1, 5), fit_error)),
               foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(numerics::rational_fit(x, y.leftCols(4), Eigen::MatrixXd::Ones(1, 5), fit_error)),
               foundation::InvalidInput);
  EXPECT_THROW(
      static_cast<void>(numerics::rational_fit(x.head(1), y.leftCols(1), Eigen::MatrixXd::Ones(1, 1), fit_error)),
      foundation::InvalidInput);
}

}  // namespace rational_fit_test
