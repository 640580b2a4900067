// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "support/projects.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/results/design/sample_document.h"
#include "trivet/study/sample/band_tally.h"
#include "trivet/study/sample/sample.h"

namespace trivet {
namespace sample_bands_test {

using testing::HasSubstr;

/// Two masses in a row under a force.
const std::string machine = test::driven_pair() + R"(
[analyses]
response = {of = ["m1.x"], band = ["2 Hz", "20 Hz"]}
sample = {designs = 3000, bands = ["coordinates", "m1.x"], band_points = 50}
[tolerances.rubber]
path = ["elements.k1.scale", "elements.k2.scale"]
half_width = "15 %"
[tolerances.casting]
path = "bodies.m1.mass"
standard_deviation = "3 %"
[requirements]
limits = {"m1.x" = "2.2 mm", "m2.x" = {limit = "3.6 mm", band = ["5 Hz", "30 Hz"]}}
)";

std::string json_with(const project::Project& project, int threads) {
  const foundation::ThreadLimit limit(threads);
  return results::as_json_text(results::sample_document(study::sample(project), {}));
}

TEST(SampledBands, AreTheSameForAnyNumberOfThreads) {
  const project::Project project = test::project(machine);
  const std::string one = json_with(project, 1);
  EXPECT_THAT(one, HasSubstr("\"largest_design\": ["));
  EXPECT_EQ(json_with(project, 2), one);
  EXPECT_EQ(json_with(project, 4), one);
}

TEST(SampledBands, HaveEachResultOnceWithItsLimitAndThePeaksOfTheGivenDesign) {
  const study::Sample found = study::sample(test::project(machine));
  const std::vector<study::SampledBand>& bands = found.cases[0].bands;
  ASSERT_EQ(bands.size(), 2);
  EXPECT_EQ(bands[0].name, "m1.x");
  EXPECT_EQ(bands[1].name, "m2.x");
  ASSERT_EQ(bands[0].limits.size(), 1);
  ASSERT_EQ(bands[1].limits.size(), 1);
  EXPECT_DOUBLE_EQ(bands[1].limits[0].amplitude, 3.6e-3);
  EXPECT_NEAR(bands[1].limits[0].band.from, 31.4159, 1e-3);
  const study::SampledBand& band = bands[0];
  EXPECT_TRUE(std::ranges::is_sorted(band.angular_frequency));
  EXPECT_GT(band.angular_frequency.size(), 50) << "the peaks are added";
  EXPECT_LE(band.angular_frequency.size(), 54);
  for (std::size_t f = 0; f < band.spread.size(); ++f) {
    const study::Spread& one = band.spread[f];
    EXPECT_LE(one.extremes.least, one.low);
    EXPECT_LE(one.low, one.median);
    EXPECT_LE(one.median, one.high);
    EXPECT_LE(one.high, one.extremes.largest);
    EXPECT_LE(one.extremes.least, band.given[f]);
    EXPECT_LE(band.given[f], one.extremes.largest);
  }
}

// Margins do not depend on whether bands are counted.
TEST(SampledBands, ChangeNoMargin) {
  std::string plain = machine;
  const std::string bands = R"(, bands = ["coordinates", "m1.x"], band_points = 50)";
  plain.erase(plain.find(bands), bands.size());
  const study::Sample with = study::sample(test::project(machine)), without = study::sample(test::project(plain));
  EXPECT_TRUE(without.cases[0].bands.empty());
  EXPECT_EQ(with.yield.met, without.yield.met);
  EXPECT_EQ(with.cases[0].in_kernels, without.cases[0].in_kernels);
  for (std::size_t r = 0; r < 2; ++r)
    EXPECT_EQ(with.cases[0].requirements[r].margin.extremes, without.cases[0].requirements[r].margin.extremes);
}

// A mass of which 0.3 % are negative: those designs have no model.
TEST(SampledBands, DoNotContainDesignsWithoutAModel) {
  const study::Sample found = study::sample(test::project(machine, {"tolerances.casting.standard_deviation=\"37 %\""}));
  ASSERT_GT(found.failed, 0);
  const std::string text = results::as_text(results::sample_document(found, {}), {});
  EXPECT_THAT(text, HasSubstr("of " + std::to_string(3000 - found.failed) + " designs"));
  EXPECT_THAT(text, HasSubstr("that could not be judged are in no band"));
}

TEST(BandTally, IsTheSameFromItsWordsAndInPieces) {
  const Eigen::ArrayXd a = Eigen::ArrayXd::LinSpaced(4, 0, 3e-3), b = 2 * a + 1e-5;
  Eigen::ArrayXd unbounded = a;
  unbounded(2) = std::numeric_limits<double>::infinity();
  study::BandTally all(4), first(4), second(4), again(4);
  for (const auto& [numbers, design] : {std::pair(a, 3), {b, 1}, {unbounded, 2}})
    all.add(numbers, static_cast<std::uint64_t>(design));
  first.add(unbounded, 2);
  first.add(a, 3);
  second.add(b, 1);
  second.merge(first);
  foundation::StoredWords words;
  second.store(words);
  foundation::WordReader reader(words.words());
  again.restore(reader);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(again.values()[i].amplitudes, all.values()[i].amplitudes);
    EXPECT_EQ(again.values()[i].extremes, all.values()[i].extremes);
  }
  EXPECT_EQ(all.values()[2].amplitudes.quantile(1), std::numeric_limits<double>::infinity());
  study::BandTally other(3);
  foundation::WordReader once_more(words.words());
  EXPECT_THROW(other.restore(once_more), foundation::DamagedText);
}

}  // namespace sample_bands_test
}  // namespace trivet
