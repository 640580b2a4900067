// SPDX-License-Identifier: BSD-3-Clause
// Levenberg–Marquardt against the certified values of the Statistical Reference Datasets (NIST StRD, nonlinear
// regression, public domain): parameters, their standard deviations and the sum of squares, from both official starts.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/matchers.h"
#include "trivet/foundation/index.h"
#include "trivet/identification/levenberg_marquardt.h"

namespace certified_least_squares_test {

using namespace trivet;
using test::RelativelyNear;

struct Certified {
  std::string name;
  std::vector<double> x, y;
  std::function<double(const Eigen::VectorXd&, double)> model;
  std::vector<std::vector<double>> starts;
  std::vector<double> parameters, deviations;
  double sum_of_squares = 0;
};

/// Dental research, adsorption; lower level of difficulty.
Certified misra1a() {
  return {"Misra1a",
          {77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0},
          {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78},
          [](const Eigen::VectorXd& b, double x) { return b(0) * (1 - std::exp(-b(1) * x)); },
          {{500, 0.0001}, {250, 0.0005}},
          {2.3894212918e2, 5.5015643181e-4},
          {2.7070075241, 7.2668688436e-6},
          1.2455138894e-1};
}

/// Electron mobility of semiconductors; higher level of difficulty.
Certified thurber() {
  return {
      "Thurber",
      {-3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481, -2.363, -2.322, -1.501,
       -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714, -0.566, -0.545, -0.400, -0.309, -0.109, -0.103,
       0.010,  0.119,  0.377,  0.790,  0.963,  1.006,  1.115,  1.572,  1.841,  2.047,  2.200},
      {80.574,   84.248,   87.264,   87.195,   89.076,   89.608,   89.868,   90.101,   92.405,   95.854,
       100.696,  101.060,  401.672,  390.724,  567.534,  635.316,  733.054,  759.087,  894.206,  990.785,
       1090.109, 1080.914, 1122.643, 1178.351, 1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509,
       1425.208, 1421.384, 1442.962, 1464.350, 1468.705, 1447.894, 1457.628},
      [](const Eigen::VectorXd& b, double x) {
        return (b(0) + x * (b(1) + x * (b(2) + x * b(3)))) / (1 + x * (b(4) + x * (b(5) + x * b(6))));
      },
      {{1000, 1000, 400, 40, 0.7, 0.3, 0.03}, {1300, 1500, 500, 75, 1, 0.4, 0.05}},
      {1.2881396800e3, 1.4910792535e3, 5.8323836877e2, 7.5416644291e1, 9.6629502864e-1, 3.9797285797e-1,
       4.9727297349e-2},
      {4.6647963344, 3.9571156086e1, 2.8698696102e1, 5.5675370270, 3.1333340687e-2, 1.4984928198e-2, 6.5842344623e-3},
      5.6427082397e3};
}

/// Kowalik and Osborne 1978; higher level of difficulty, its first start is far away.
Certified mgh09() {
  return {"MGH09",
          {4, 2, 1, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625},
          {0.1957, 0.1947, 0.1735, 0.16, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246},
          [](const Eigen::VectorXd& b, double x) { return b(0) * (x * x + x * b(1)) / (x * x + x * b(2) + b(3)); },
          {{25, 39, 41.5, 39}, {0.25, 0.39, 0.415, 0.39}},
          {1.9280693458e-1, 1.9128232873e-1, 1.2305650693e-1, 1.3606233068e-1},
          {1.1435312227e-2, 1.9633220911e-1, 8.0842031232e-2, 9.0025542308e-2},
          3.0750560385e-4};
}

class CertifiedLeastSquares : public testing::TestWithParam<Certified> {};

TEST_P(CertifiedLeastSquares, AreMetFromBothStarts) {
  constexpr double parameters = 1e-7;  // steps end at 1e-10, amplified by correlated parameters
  constexpr double squares = 1e-10;    // printed digits
  constexpr double deviations = 2e-7;  // the same, and the numeric Jacobian
  const Certified& problem = GetParam();
  const Eigen::Index rows = to_index(problem.x.size()), count = to_index(problem.parameters.size());
  // Logarithms of the parameters, as law_fit uses the method.
  const auto residuals = [&](const Eigen::VectorXd& logarithms) -> Eigen::VectorXd {
    const Eigen::VectorXd b = logarithms.array().exp();
    Eigen::VectorXd result(rows);
    for (Eigen::Index i = 0; i < rows; ++i) result(i) = problem.y[i] - problem.model(b, problem.x[i]);
    return result;
  };
  for (const std::vector<double>& start : problem.starts) {
    const Eigen::VectorXd logarithms = Eigen::Map<const Eigen::VectorXd>(start.data(), count).array().log();
    const identification::LeastSquaresMinimum found = identification::least_squares_minimum(residuals, logarithms);
    const std::string from = problem.name + " from " + std::to_string(start.front());
    EXPECT_TRUE(found.converged) << from;
    EXPECT_THAT(found.residuals.squaredNorm(), RelativelyNear(problem.sum_of_squares, squares)) << from;
    const double variance = found.residuals.squaredNorm() / static_cast<double>(rows - count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double value = std::exp(found.parameters(i));
      EXPECT_THAT(value, RelativelyNear(problem.parameters[i], parameters)) << from << ", parameter " << i + 1;
      EXPECT_THAT(value * std::sqrt(variance * found.unit_covariance(i, i)),
                  RelativelyNear(problem.deviations[i], deviations))
          << from << ", parameter " << i + 1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(NistStrd, CertifiedLeastSquares, testing::Values(misra1a(), thurber(), mgh09()),
                         [](const auto& info) { return info.param.name; });

}  // namespace certified_least_squares_test
