// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "trivet/foundation/problems.h"

namespace foundation_test {

using namespace trivet::foundation;

TEST(Problem, MessageNamesPlaceThingValueRuleAndRemedy) {
  Problem problem{Severity::error, {"a.toml", 7, 3},     "bodies.frame.mass",
                  "mass = -3 kg",  "a mass must be > 0", "correct it"};
  EXPECT_EQ(message(problem), "a.toml:7: error: bodies.frame.mass: mass = -3 kg; a mass must be > 0; correct it");
}

TEST(Problems, AreOrderedByLineAndRepeatsDropped) {
  Problems problems;
  problems.error("b", "x", "r", "").origin = {"f", 9, 0};
  problems.error("a", "x", "r", "").origin = {"f", 2, 0};
  problems.error("a", "x", "r", "").origin = {"f", 2, 0};
  problems.sort_by_origin();
  ASSERT_EQ(problems.list().size(), 2u);
  EXPECT_EQ(problems.list()[0].subject, "a");
}

TEST(Problems, WarningsAloneAreNoErrors) {
  Problems problems;
  problems.warning("a", "", "", "");
  EXPECT_FALSE(problems.has_errors());
  problems.error("a", "", "", "");
  EXPECT_TRUE(problems.has_errors());
}

TEST(NearestName, FindsTypingErrorsOnly) {
  const std::vector<std::string> known = {"stiffness", "damping", "scale"};
  EXPECT_EQ(nearest_name("stifness", known), "stiffness");
  EXPECT_EQ(nearest_name("dampnig", known), "damping");
  EXPECT_EQ(nearest_name("temperature", known), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'x'), known), "");
}

}  // namespace foundation_test
