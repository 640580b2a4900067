// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/first_error.h"

#include <gtest/gtest.h>

#include "trivet/foundation/invalid_input.h"

namespace first_error_test {

using namespace trivet::foundation;

Problems warning_before_error() {
  Problems problems;
  problems.warning("bodies.m", "thin", "it is thick", "thicken it");
  problems.error("bodies.m.mass", "-3 kg", "a mass must be > 0", "correct it");
  return problems;
}

TEST(FirstError, IsNotAWarningBeforeIt) {
  const Problems problems = warning_before_error();
  ASSERT_NE(first_error(problems), nullptr);
  EXPECT_EQ(first_error(problems)->subject, "bodies.m.mass");
  EXPECT_EQ(&error_of(problems), first_error(problems));
  EXPECT_EQ(first_reason(problems), "bodies.m.mass: -3 kg; a mass must be > 0");
  EXPECT_EQ(first_message(problems), "error: bodies.m.mass: -3 kg; a mass must be > 0; correct it");
  EXPECT_THROW(refuse_errors(problems), InvalidInput);
}

TEST(FirstError, IsNoneOfWarnings) {
  Problems problems;
  problems.warning("bodies.m", "thin", "it is thick", "thicken it");
  EXPECT_EQ(first_error(problems), nullptr);
  EXPECT_EQ(first_message(problems), "");
  EXPECT_NO_THROW(refuse_errors(problems));
}

}  // namespace first_error_test
