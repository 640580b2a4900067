// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/search/max_min.h"

#include <gtest/gtest.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace max_min_test {

using namespace trivet::numerics;

/// The search ends at steps of 1e-10; at a smooth maximum that leaves the square root of the digits.
constexpr double place = 1e-6, value = 1e-9;
constexpr double active = 1e-6;

MaxMinProblem problem(Eigen::Index variables, std::vector<bool> is_objective,
                      std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::MatrixXd&)> evaluate) {
  return {variables, std::move(is_objective),
          [evaluate](const Eigen::VectorXd& x, Eigen::VectorXd& values, Eigen::MatrixXd* slopes) {
            Eigen::MatrixXd unused;
            evaluate(x, values, slopes ? *slopes : unused);
          }};
}

TEST(MaxMin, BalancesTwoLines) {
  const MaxMinProblem lines = problem(1, {true, true}, [](const auto& x, auto& values, auto& slopes) {
    values = Eigen::Vector2d(2 * x(0), 1 - x(0));
    slopes = Eigen::Vector2d(2, -1);
  });
  const MaxMinPoint found = max_min(lines, Eigen::VectorXd::Constant(1, 0.9));
  EXPECT_NEAR(found.x(0), 1.0 / 3, value);
  EXPECT_NEAR(found.objective, 2.0 / 3, value);
  EXPECT_TRUE(std::isinf(found.constraint));
  // λ₁ 2 = λ₂ 1, λ₁ + λ₂ = 1
  const Multipliers held = multipliers(lines, found, active);
  EXPECT_NEAR(held.of_values(0), 1.0 / 3, place);
  EXPECT_NEAR(held.of_values(1), 2.0 / 3, place);
  EXPECT_LT(held.residual, place);
}

TEST(MaxMin, FindsASmoothMaximumInside) {
  const MaxMinProblem hill = problem(2, {true}, [](const auto& x, auto& values, auto& slopes) {
    const double a = x(0) - 0.3, b = x(1) - 0.6;
    values = Eigen::VectorXd::Constant(1, 1 - a * a - 10 * b * b - 3 * a * b);
    slopes = Eigen::RowVector2d(-2 * a - 3 * b, -20 * b - 3 * a);
  });
  const MaxMinPoint found = max_min(hill, Eigen::Vector2d(0.95, 0.05));
  EXPECT_NEAR(found.x(0), 0.3, place);
  EXPECT_NEAR(found.x(1), 0.6, place);
  EXPECT_NEAR(found.objective, 1, value);
  // All slopes vanish there, so that the largest of them is no scale. The error of the place times 1/1e-2:
  EXPECT_LT(multipliers(hill, found, active).residual, 1e-2);
}

TEST(MaxMin, KeepsConstraintsAndBounds) {
  const MaxMinProblem corner = problem(2, {true, false}, [](const auto& x, auto& values, auto& slopes) {
    values = Eigen::Vector2d(x(0) + 3 * x(1), 0.7 - x(0));
    slopes = (Eigen::Matrix2d() << 1, 3, -1, 0).finished();
  });
  const MaxMinPoint found = max_min(corner, Eigen::Vector2d(0.1, 0.1));
  EXPECT_NEAR(found.x(0), 0.7, value);
  EXPECT_NEAR(found.x(1), 1, value);
  // The constraint holds x as strongly as the objective pulls; y is held by its bound.
  const Multipliers held = multipliers(corner, found, active);
  EXPECT_NEAR(held.of_values(0), 1, place);
  EXPECT_NEAR(held.of_values(1), 1, place);
  EXPECT_LT(held.residual, place);
}

TEST(MaxMin, NoMultipliersBalanceAPointThatIsNoOptimum) {
  const MaxMinProblem slope = problem(1, {true}, [](const auto& x, auto& values, auto& slopes) {
    values = Eigen::VectorXd::Constant(1, x(0));
    slopes = Eigen::MatrixXd::Constant(1, 1, 1);
  });
  EXPECT_NEAR(multipliers(slope, {Eigen::VectorXd::Constant(1, 0.5), 0.5, 0}, active).residual, 1, place);
  EXPECT_LT(multipliers(slope, {Eigen::VectorXd::Ones(1), 1, 0}, active).residual, place);
}

TEST(MaxMin, PassesExceptionsOn) {
  int calls = 0;
  const MaxMinProblem failing = problem(1, {true}, [&](const auto& x, auto& values, auto& slopes) {
    if (++calls > 2) throw trivet::foundation::NotComputable("stopped here");
    values = Eigen::VectorXd::Constant(1, x(0));
    slopes = Eigen::MatrixXd::Constant(1, 1, 1);
  });
  EXPECT_THROW(static_cast<void>(max_min(failing, Eigen::VectorXd::Constant(1, 0.5))),
               trivet::foundation::NotComputable);
}

}  // namespace max_min_test
