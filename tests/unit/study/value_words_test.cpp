// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/results/design/verdict_words.h"
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

/// "0.05" and "3 %", not "0.05 1".
TEST(ValueWords, OfPureNumbersHaveNoUnit) {
  for (int kind = 0; kind <= static_cast<int>(study::RequirementKind::clearance); ++kind) {
    study::RequirementResult result;
    result.kind = static_cast<study::RequirementKind>(kind);
    result.unit = "1";
    result.allowed = 0.1;
    const study::ShownValue shown = study::requirement_row(result.kind).shown;
    if (shown != study::ShownValue::number && shown != study::ShownValue::count && shown != study::ShownValue::share &&
        shown != study::ShownValue::share_of_line)
      continue;  // these have units
    EXPECT_THAT(results::value_words(result, 0.05, {}), testing::MatchesRegex("0\\.05|5 %"))
        << study::name(result.kind);
  }
}

}  // namespace value_words_test
