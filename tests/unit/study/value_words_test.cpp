// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/study/explain/explanation.h"

namespace value_words_test {

using namespace trivet;

/// Sentences of studies and tables of documents have one rule for prefixes.
TEST(ValueWords, HaveThePrefixesOfTheTables) {
  for (const char* unit : {"m", "m/s", "rad", "N", "N m", "W", "kg", "1"})
    for (int power = -12; power <= 3; ++power) {
      const double value = 2.5 * std::pow(10.0, power);
      EXPECT_EQ(study::value_words(value, unit), documents::value_text(value, documents::display_unit({}, unit)));
    }
  EXPECT_EQ(study::value_words(0, "m"), "0 m");
}

}  // namespace value_words_test
