// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "trivet/design/design_outcome.h"

namespace design_outcome_test {

using namespace trivet;

TEST(MissingKinds, AreMessagesWithoutTheirNumbers) {
  EXPECT_EQ(design::without_numbers("mass = -5.25e-3 kg of mount2; a mass must be > 0"),
            "mass = # kg of mount2; a mass must be > #");
  EXPECT_EQ(design::without_numbers("eigenvalues 1.5, 3 and 4e+05"),
            design::without_numbers("eigenvalues -2, 77.125 and 1"));
  EXPECT_NE(design::without_numbers("element a1: 3"), design::without_numbers("element a2: 3"));
}

}  // namespace design_outcome_test
