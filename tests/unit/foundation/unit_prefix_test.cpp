// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/unit_prefix.h"

#include <gtest/gtest.h>

#include "trivet/foundation/significant_digits.h"

namespace unit_prefix_test {

using namespace trivet::foundation;

TEST(UnitPrefix, BringsNumbersNearOneToAThousand) {
  EXPECT_EQ(prefixed(0.01053, "m"), "10.53 mm");
  EXPECT_EQ(prefixed(1.6433e-7, "m"), "164.3 nm");
  EXPECT_EQ(prefixed(2.437e5, "N/m"), "243.7 kN/m");
  EXPECT_EQ(prefixed(12.4e6, "Pa"), "12.4 MPa");
  EXPECT_EQ(prefixed_exactly(0.0123456, "m", 6), "12.3456 mm");
  EXPECT_EQ(prefixed_range(500, 7000, "N"), "0.5 … 7 kN");
  EXPECT_EQ(prefixed(0, "m"), "0 m");
}

TEST(UnitPrefix, OfAKilogramIsNone) {
  EXPECT_EQ(prefixed(0.5, "kg"), "0.5 kg");
  EXPECT_EQ(prefixed(12000, "kg"), "12000 kg");
  EXPECT_EQ(prefixed(0.02, "kg m"), "0.02 kg m");
}

TEST(UnitPrefix, OfVelocitiesOfMachinesIsMilli) {
  EXPECT_EQ(prefixed(836.4e-6, "m/s"), "0.8364 mm/s");
  EXPECT_EQ(prefixed(4.5e-3, "m/s"), "4.5 mm/s");
  EXPECT_EQ(prefixed(100e-6, "m/s"), "0.1 mm/s");
  EXPECT_EQ(prefixed(50e-6, "m/s"), "50 µm/s");  // VC-A
  EXPECT_EQ(prefixed(836.4e-6, "m/s²"), "836.4 µm/s²");
}

}  // namespace unit_prefix_test
