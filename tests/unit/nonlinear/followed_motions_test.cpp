// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/followed_motions.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/cubic_branch.h"

namespace followed_motions_test {

using namespace trivet;
using nonlinear::FollowedMotions;
using numerics::BranchPoint;
using test::cubic_with_two_folds;

void follow(const numerics::Branch& branch, const BranchPoint& first, double to, FollowedMotions& motions) {
  constexpr double step = 0.2;
  motions.begin(first);
  while (std::abs(motions.points().back().unknowns(0)) < to)
    motions.add(branch.after(motions.points().back(), step).value(), step);
}

std::vector<double> places(const std::vector<BranchPoint>& points) {
  std::vector<double> found;
  for (const BranchPoint& point : points) found.push_back(point.unknowns(0));
  return found;
}

class JoinedMotions : public testing::Test {
 protected:
  /// From u = −1.5 upwards through both folds, and then downwards.
  void SetUp() override {
    const BranchPoint middle = branch.start(Eigen::VectorXd::Constant(1, -1.5), 1.125).value();
    FollowedMotions onward(branch, wanted);
    follow(branch, middle, 2.5, onward);
    onward.add_corner(7);
    follow(branch, FollowedMotions::reversed(middle), 2.5, joined);
    joined.add_corner(6);
    joined.add_corner(5);
    points_of_both = onward.points().size() + joined.points().size();
    joined.reverse_and_append(onward);
  }

  void expect_all_at_zero() const {
    constexpr double exact = 1e-12;
    const double root = std::sqrt(3.0);
    EXPECT_THAT(places(joined.all_at(0)),
                testing::ElementsAre(testing::DoubleNear(-root, exact), testing::DoubleNear(0, exact),
                                     testing::DoubleNear(root, exact)));
    ASSERT_EQ(joined.turns().size(), 2u);
    for (const double fold : {-1.0, 1.0}) {
      const FollowedMotions::Turn& turn = joined.turns()[fold < 0 ? 0 : 1];
      EXPECT_EQ(turn.upper, fold < 0);
      EXPECT_NEAR(turn.point.parameter, -2 * fold, exact);
      EXPECT_LT(joined.points()[turn.after].unknowns(0), fold);
      EXPECT_GT(joined.points()[turn.after + 1].unknowns(0), fold);
    }
  }

  const std::vector<double> wanted = {0};
  const numerics::Branch branch{cubic_with_two_folds, Eigen::VectorXd::Constant(1, 1), 1};
  FollowedMotions joined{branch, wanted};
  std::size_t points_of_both = 0;
};

TEST_F(JoinedMotions, FollowTheCurveFromEndToEnd) {
  const std::vector<double> along = places(joined.points());
  EXPECT_EQ(along.size(), points_of_both - 1) << "the first motion of both sides stands there once";
  EXPECT_TRUE(std::ranges::is_sorted(along));
  EXPECT_LT(along.front(), -2.4);
  EXPECT_GT(along.back(), 2.4);
  EXPECT_THAT(joined.corners(), testing::ElementsAre(5, 6, 7));
  EXPECT_EQ(places(joined.requested()), places(joined.all_at(0)));
  expect_all_at_zero();
}

TEST_F(JoinedMotions, KeepTheirPlacesWhereAStepIsSplit) {
  const std::size_t before = joined.points().size();
  for (const std::size_t step : {std::size_t{0}, joined.turns()[0].after + 2, before})
    ASSERT_TRUE(joined.split_step(step));
  EXPECT_EQ(joined.points().size(), before + 3);
  expect_all_at_zero();
}

TEST_F(JoinedMotions, CanBeCutBackToAnExtent) {
  const FollowedMotions::Extent all = joined.extent();
  joined.add(branch.after(joined.points().back(), 0.3).value(), 0.3);
  joined.cut_to(all);
  EXPECT_EQ(joined.points().size(), all.points);
  expect_all_at_zero();
}

/// A curve that begins upright, as one of twice the period does where it leaves another: λ changes by 1e-12 up to u
/// = 1.
TEST(FollowedMotions, TurnsOfRoundOffAreNoFolds) {
  const numerics::Branch upright(
      [](const Eigen::VectorXd& u, double parameter, numerics::Equations& equations) {
        const double beyond = std::max(u(0) - 1, 0.0);
        equations.value = Eigen::VectorXd::Constant(1, parameter - 1e-12 * std::sin(40 * u(0)) - std::pow(beyond, 3));
        equations.by_unknowns = Eigen::MatrixXd::Constant(1, 1, -4e-11 * std::cos(40 * u(0)) - 3 * beyond * beyond);
        equations.by_parameter = Eigen::VectorXd::Constant(1, 1);
      },
      Eigen::VectorXd::Constant(1, 1), 1);
  const std::vector<double> wanted;
  FollowedMotions motions(upright, wanted);
  constexpr double first = 0.01, step = 0.03;
  motions.begin(upright.start(Eigen::VectorXd::Constant(1, first), 1e-12 * std::sin(40 * first)).value());
  while (motions.points().back().unknowns(0) < 1.8)
    motions.add(upright.after(motions.points().back(), step).value(), step);
  EXPECT_FALSE(motions.turns().empty());
  motions.remove_turns_of_round_off();
  EXPECT_TRUE(motions.turns().empty());
}

TEST_F(JoinedMotions, KeepTheirFolds) {
  joined.remove_turns_of_round_off();
  expect_all_at_zero();
}

}  // namespace followed_motions_test
