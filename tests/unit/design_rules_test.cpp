// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <limits>

#include "trivet/response/design_rules.h"

namespace {

using namespace trivet;

/// Four limits of 1, so that a margin is 1 / value.
const response::RuleSet four_limits{std::vector<response::DesignRule>(4, {response::DesignRule::Kind::amplitude, 0, 1.0}), {}, 1e-6};

TEST(Governing, TakesTheFirstOfRulesThatRoundOffAloneTellsApart) {
  const response::Governing found = response::governing(four_limits, {0.1, 2 * (1 - 1e-13), 2.0, 2 * (1 + 1e-9)});
  EXPECT_EQ(found.rule, 1u);
  EXPECT_EQ(found.margin, 1 / (2 * (1 + 1e-9)));
}

TEST(Governing, TakesTheLeastWhereADesignTellsRulesApart) { EXPECT_EQ(response::governing(four_limits, {0.1, 2.0, 2.0001, 2.00005}).rule, 2u); }

TEST(Governing, NamesNoKeptRuleWhereOneIsBroken) { EXPECT_EQ(response::governing(four_limits, {1 - 1e-9, 1 + 1e-9, 1.0, 0.5}).rule, 1u); }

TEST(Governing, HasNoBoundWhereNoRuleHasAMargin) {
  const response::Governing found = response::governing(four_limits, {0, 0, 0, 0});
  EXPECT_EQ(found.rule, 0u);
  EXPECT_EQ(found.margin, std::numeric_limits<double>::infinity());
}

}  // namespace
