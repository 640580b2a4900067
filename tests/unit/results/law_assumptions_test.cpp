// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/law_assumptions.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "trivet/project/elements/element_reader.h"

namespace law_assumptions_test {

using namespace trivet;
using testing::HasSubstr;

TEST(LawAssumptions, HaveAllTypesOfElements) {
  const std::vector<results::LawAssumption> list = results::law_assumptions();
  for (const std::string& type : project::element_law_names())
    EXPECT_EQ(std::ranges::count_if(list, [&](const auto& one) { return one.law == type; }), 1) << type;
}

TEST(LawAssumptions, AreThoseOfTheDocument) {
  std::ifstream file(TRIVET_SOURCE_DIR "/docs/elements/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const results::LawAssumption& one : results::law_assumptions()) {
    const std::string law = one.law;
    EXPECT_THAT(text,
                testing::AnyOf(HasSubstr("| `" + law + "` | " + one.words + " |"),
                               HasSubstr("| " + law + " | " + one.words + " |")));
  }
}

}  // namespace law_assumptions_test
