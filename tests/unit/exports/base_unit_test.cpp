// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/unit_variables.h"

#include <gmock/gmock.h>

#include "trivet/foundation/invalid_input.h"

namespace base_unit_test {

using trivet::exports::base_unit;
using trivet::exports::BaseUnit;
using trivet::exports::per_second;
using trivet::foundation::InvalidInput;

TEST(BaseUnit, HasTheExponentsOfCoherentUnits) {
  EXPECT_EQ(base_unit("m"), (BaseUnit{.m = 1}));
  EXPECT_EQ(base_unit("1"), BaseUnit{});
  EXPECT_EQ(base_unit("1/s"), (BaseUnit{.s = -1}));
  EXPECT_EQ(base_unit("rad/s2"), (BaseUnit{.s = -2, .rad = 1}));
  EXPECT_EQ(base_unit("N m"), (BaseUnit{.kg = 1, .m = 2, .s = -2}));
  EXPECT_EQ(base_unit("N s/m"), (BaseUnit{.kg = 1, .s = -1}));
  EXPECT_EQ(base_unit("kg m2"), (BaseUnit{.kg = 1, .m = 2}));
  EXPECT_EQ(base_unit("N m/rad"), (BaseUnit{.kg = 1, .m = 2, .s = -2, .rad = -1}));
  EXPECT_EQ(base_unit("W"), base_unit("N m/s"));
  EXPECT_EQ(base_unit("Pa"), base_unit("N/m2"));
  EXPECT_EQ(base_unit("V"), base_unit("W/A"));
}

TEST(BaseUnit, IsTheSameInAllSpellings) {
  for (const char* spelling : {"m/s2", "m/s²", "m/s^2", "m s-2", "m s^-2", "m/s/s", "m / s2", "s-2·m", "s-2*m"})
    EXPECT_EQ(base_unit(spelling), (BaseUnit{.m = 1, .s = -2})) << spelling;
}

TEST(BaseUnit, RejectsUnitsThatAreNotCoherentOrNotClear) {
  for (const char* unit :
       {"", " ", "mm", "g", "Hz", "m/", "/s", "m//s", "N/m s", "m2.5", "m0", "s22", "deg", "m(s)", "2"})
    EXPECT_THROW(static_cast<void>(base_unit(unit)), InvalidInput) << unit;
}

TEST(BaseUnit, OfADerivativeHasOneSecondLess) {
  EXPECT_EQ(per_second("m"), "m/s");
  EXPECT_EQ(per_second("m/s"), "m/s2");
  EXPECT_EQ(per_second(""), "1/s");
  for (const char* unit : {"m", "m/s", "m/s2", "m/s²", "m/s^2", "N m", "1", "rad/s", "N/m"}) {
    BaseUnit expected = base_unit(unit);
    --expected.s;
    EXPECT_EQ(base_unit(per_second(unit)), expected) << unit;
  }
}

}  // namespace base_unit_test
