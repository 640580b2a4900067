// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "trivet/results/axis_words.h"

namespace {

using namespace trivet;

TEST(AxisUnit, IsTheGivenOneOrThatOfABareNumber) {
  EXPECT_EQ(results::axis_unit({"elements.d.coefficient", "", 1, 2, "kN s/m", false, 11}), "kN s/m");
  EXPECT_EQ(results::axis_unit({"elements.d.coefficient", "", 1, 2, "", false, 11}), "N s/m");
  EXPECT_EQ(results::axis_unit({"elements.s.damping.proportional", "", 1, 2, "", false, 11}), "s");
  EXPECT_EQ(results::axis_unit({"elements.s.scale", "", 1, 2, "", false, 11}), "");
}

TEST(AxisValue, HasEnoughDigitsToDistinguishDesigns) {
  EXPECT_EQ(results::axis_value(1.3, {"elements.s.scale", "", 1, 2, "", false, 11}), "1.3");
  EXPECT_EQ(results::axis_value(1.00000000005, {"elements.s.scale", "", 1, 1.0000000001, "", false, 9}),
            "1.00000000005");
  EXPECT_EQ(results::axis_value(0.12, {"elements.s.damping.proportional", "", 0.01, 0.5, "", true, 101}), "0.12 s");
}

}  // namespace
