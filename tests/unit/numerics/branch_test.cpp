// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/branch.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "support/cubic_branch.h"

namespace branch_test {

using namespace trivet;
using numerics::Branch;
using numerics::BranchPoint;
using test::cubic_with_two_folds;

TEST(Branch, PassesBothFoldsOfACubic) {
  const Branch branch(cubic_with_two_folds, Eigen::VectorXd::Constant(1, 1), 1);
  std::optional<BranchPoint> now = branch.start(Eigen::VectorXd::Constant(1, -3), -5);
  ASSERT_TRUE(now);
  std::vector<BranchPoint> folds;
  while (now->parameter < 5) {
    const std::optional<BranchPoint> next = branch.after(*now, 0.1);
    ASSERT_TRUE(next);
    EXPECT_NEAR(std::pow(next->unknowns(0), 3) - 3 * next->unknowns(0), next->parameter, 1e-12);
    if (next->parameter_direction() * now->parameter_direction() < 0) {
      folds.push_back(branch.fold(*now, 0.1));
    }
    now = next;
  }
  ASSERT_EQ(folds.size(), 2u);
  EXPECT_NEAR(folds[0].parameter, 2, 1e-13);
  EXPECT_NEAR(folds[0].unknowns(0), -1, 1e-7);
  EXPECT_NEAR(folds[1].parameter, -2, 1e-13);
  EXPECT_NEAR(folds[1].unknowns(0), 1, 1e-7);
}

TEST(Branch, FindsTheSolutionAtAParameterBetweenTwoPoints) {
  const Branch branch(cubic_with_two_folds, Eigen::VectorXd::Constant(1, 1), 1);
  const std::optional<BranchPoint> from = branch.start(Eigen::VectorXd::Constant(1, -3), -5);
  ASSERT_TRUE(from);
  for (const double step : {0.1, 0.8}) {  // near enough for the cubic between them, and too far for it
    const std::optional<BranchPoint> to = branch.after(*from, step);
    ASSERT_TRUE(to);
    const double parameter = (from->parameter + 2 * to->parameter) / 3;
    const std::optional<BranchPoint> there = branch.at(parameter, *from, *to);
    ASSERT_TRUE(there);
    EXPECT_EQ(there->parameter, parameter);
    EXPECT_NEAR(std::pow(there->unknowns(0), 3) - 3 * there->unknowns(0), parameter, 1e-12);
    EXPECT_GT(there->unknowns(0), from->unknowns(0));
    EXPECT_LT(there->unknowns(0), to->unknowns(0));
  }
}

/// λ = u up to u = 1, and 4 − 3u beyond: the direction turns by more than a right angle.
Branch with_kink() {
  return {[](const Eigen::VectorXd& u, double parameter, numerics::Equations& equations) {
            const double slope = u(0) < 1 ? 1 : -3;
            equations.value = Eigen::VectorXd::Constant(1, 1 + slope * (u(0) - 1) - parameter);
            equations.by_unknowns = Eigen::MatrixXd::Constant(1, 1, slope);
            equations.by_parameter = Eigen::VectorXd::Constant(1, -1);
          },
          Eigen::VectorXd::Constant(1, 1), 1};
}

BranchPoint before_kink(double u) { return with_kink().start(Eigen::VectorXd::Constant(1, u), u).value(); }

TEST(Branch, HasTheSameOrientationBeyondASharpKink) {
  const Branch branch = with_kink();
  const BranchPoint before = before_kink(0.9);
  BranchPoint beyond = branch.start(Eigen::VectorXd::Constant(1, 1.1), 0.7, true).value();
  EXPECT_GT(before.tangent(0), 0);
  EXPECT_GT(beyond.tangent(0), 0);
  EXPECT_LT(before.tangent.dot(beyond.tangent), 0);
  EXPECT_NE(branch.orientation(before), 0);
  EXPECT_EQ(branch.orientation(before), branch.orientation(beyond));
  beyond.tangent = -beyond.tangent;
  EXPECT_EQ(branch.orientation(before), -branch.orientation(beyond));
}

TEST(Branch, GoesOnBeyondASharpKinkWhereTheParameterTurns) {
  constexpr double any = std::numeric_limits<double>::infinity(), least = 1e-4;
  const BranchPoint before = before_kink(1 - 1e-5);
  const auto hop = with_kink().beyond_kink(before, least, -any, any);
  ASSERT_TRUE(hop);
  EXPECT_GE(hop->length, least);
  EXPECT_GT(hop->to.unknowns(0), 1);
  EXPECT_NEAR(hop->to.parameter, 4 - 3 * hop->to.unknowns(0), 1e-14);
  EXPECT_GT(hop->to.tangent(0), 0);
  EXPECT_FALSE(with_kink().beyond_kink(before, least, before.parameter, any));
}

TEST(Branch, HasItsFoldAtASharpKink) {
  const BranchPoint before = before_kink(0.9);
  EXPECT_FALSE(with_kink().after(before, 0.3));
  constexpr double not_shrinking = 1e-8;  // steps below are taken for round-off
  EXPECT_NEAR(with_kink().fold(before, 0.3).parameter, 1, not_shrinking);
}

TEST(Branch, HasNoPointWhereThereIsNoSolution) {
  const Branch branch(
      [](const Eigen::VectorXd& u, double, numerics::Equations& equations) {
        equations.value = Eigen::VectorXd::Constant(1, u(0) * u(0) + 1);
        equations.by_unknowns = Eigen::MatrixXd::Constant(1, 1, 2 * u(0));
        equations.by_parameter = Eigen::VectorXd::Zero(1);
      },
      Eigen::VectorXd::Constant(1, 1), 1);
  EXPECT_FALSE(branch.start(Eigen::VectorXd::Constant(1, 0.7), 0));
}

}  // namespace branch_test
