// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/hertz.h"

#include <gtest/gtest.h>

namespace hertz_test {

using namespace trivet::foundation;

TEST(HertzWords, StateAnAngularFrequencyInHertz) {
  EXPECT_EQ(hertz_words(two_pi * 16.3333), "16.33 Hz");
  EXPECT_EQ(hertz_words(two_pi * 123456), "123456 Hz");
  EXPECT_EQ(hertz_range(two_pi * 20, two_pi * 26.04), "20 … 26.04 Hz");
}

}  // namespace hertz_test
