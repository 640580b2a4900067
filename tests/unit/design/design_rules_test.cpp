// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <limits>

#include "trivet/design/design_rules.h"

namespace design_rules_test {

using namespace trivet;

/// Four limits of 1, so a margin is 1 / value.
const design::RuleSet four_limits{
    std::vector<design::DesignRule>(4, {design::DesignRule::Kind::amplitude, 0, 1.0}), {}, 1e-6};

TEST(Governing, IsTheFirstOfRulesThatDifferByRoundOffOnly) {
  const design::Governing found = design::governing(four_limits, {0.1, 2 * (1 - 1e-13), 2.0, 2 * (1 + 1e-9)});
  EXPECT_EQ(found.rule, 1u);
  EXPECT_EQ(found.margin, 1 / (2 * (1 + 1e-9)));
}

TEST(Governing, HasTheLeastMarginIfRulesDiffer) {
  EXPECT_EQ(design::governing(four_limits, {0.1, 2.0, 2.0001, 2.00005}).rule, 2u);
}

TEST(Governing, IsAViolatedRuleIfOneIsViolated) {
  EXPECT_EQ(design::governing(four_limits, {1 - 1e-8, 1 + 1e-8, 1.0, 0.5}).rule, 1u);
}

TEST(Margin, IsOneForAValueOnItsLimit) {
  const design::DesignRule limit{design::DesignRule::Kind::amplitude, 0, 1e-3},
      no_peak{design::DesignRule::Kind::no_peak, 0, 0.01};
  EXPECT_EQ(design::margin(limit, 1.0000000000000002e-3), 1);
  EXPECT_EQ(design::margin(limit, 1e-3 * (1 + 0.9 * design::on_the_limit)), 1);
  EXPECT_LT(design::margin(limit, 1e-3 * (1 + 1.1 * design::on_the_limit)), 1);
  EXPECT_GT(design::margin(limit, 1e-3 * (1 - 1e-12)), 1);
  EXPECT_EQ(design::margin(no_peak, 0.01 * (1 + 1e-9)), 1);
  EXPECT_LT(design::margin(no_peak, 0.01 * (1 + 1e-6)), 1);
}

TEST(Governing, IsUnboundedIfNoRuleHasAMargin) {
  const design::Governing found = design::governing(four_limits, {0, 0, 0, 0});
  EXPECT_EQ(found.rule, 0u);
  EXPECT_EQ(found.margin, std::numeric_limits<double>::infinity());
}

}  // namespace design_rules_test
