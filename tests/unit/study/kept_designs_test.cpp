// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/kept_designs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "support/projects.h"
#include "trivet/foundation/stored_words.h"
#include "trivet/study/sample/drawn_designs.h"
#include "trivet/study/sample/kept_tally.h"
#include "trivet/study/sample/sample.h"

namespace trivet {
namespace unit_kept_designs_test {

using study::KeptDesign;
using study::KeptDesigns;
using study::KeptTally;
using testing::SizeIs;

constexpr double round_off = 1e-12;  // of a product of three numbers

/// The margin of a design of a made-up sample: every third one violates its requirement, every hundredth has no model.
std::vector<double> margins_of(std::uint64_t design) {
  if (design % 100 == 99) return {};
  return {design % 3 == 0 ? 0.5 : 1.5, 2.0 + static_cast<double>(design)};
}
bool meets(std::uint64_t design) { return design % 100 != 99 && design % 3 != 0; }

KeptTally tally_of(const std::vector<std::uint64_t>& designs) {
  KeptTally tally;
  for (const std::uint64_t one : designs)
    if (tally.keeps(one, meets(one))) tally.add(one, margins_of(one));
  return tally;
}

std::string text_of(const KeptTally& tally) {
  foundation::StoredWords words;
  tally.store(words);
  return words.words();
}

TEST(KeptTally, IsTheSameInAnyOrderAndInParts) {
  std::vector<std::uint64_t> up, down, parts[3];
  for (std::uint64_t i = 0; i < 2000; ++i) up.push_back(i), parts[i / 7 % 3].push_back(i);
  down.assign(up.rbegin(), up.rend());
  const KeptTally whole = tally_of(up);
  ASSERT_THAT(whole.first(), SizeIs(KeptDesigns::first));
  ASSERT_THAT(whole.failing(), SizeIs(KeptDesigns::failing));
  std::size_t failing = 0;
  for (std::uint64_t i = KeptDesigns::first; failing < KeptDesigns::failing; ++i) {
    EXPECT_EQ(whole.failing().contains(i), !meets(i)) << i;
    failing += !meets(i);
  }
  EXPECT_EQ(text_of(tally_of(down)), text_of(whole));
  KeptTally merged = tally_of(parts[2]);
  for (const int part : {0, 1}) merged.merge(tally_of(parts[part]));
  EXPECT_EQ(text_of(merged), text_of(whole));
}

TEST(KeptTally, IsRestoredFromWhatItStores) {
  const KeptTally tally = tally_of({1, 3, 99, 500, 501, 699});
  const std::string text = text_of(tally);
  foundation::WordReader words(text), of_others(text);
  EXPECT_EQ(text_of(KeptTally::restored(words, 2)), text);
  EXPECT_THROW(static_cast<void>(KeptTally::restored(of_others, 3)), foundation::DamagedText);
}

const std::string machine = test::driven_pair() + R"(
[analyses]
response = {of = ["m1.x", "m2.x"]}
[tolerances.rubber]
path = ["elements.k1.scale", "elements.k2.scale"]
half_width = "15 %"
[tolerances.casting]
path = "bodies.m1.mass"
standard_deviation = "3 %"
[requirements]
limits = {"m1.x" = "3 mm", "m2.x" = "5 mm"}
)";

study::Sample sample_of(int designs, const std::vector<std::string>& further = {}) {
  std::vector<std::string> settings = {"analyses.sample.designs=" + std::to_string(designs)};
  settings.insert(settings.end(), further.begin(), further.end());
  return study::sample(test::project(machine, settings));
}

TEST(KeptDesigns, HaveTheNumbersThatAreDrawnForThem) {
  const study::Sample found = sample_of(3000);
  const study::DrawnDesigns drawn(found.tolerances, found.request);
  ASSERT_THAT(found.kept.numbers, SizeIs(3));
  EXPECT_EQ(found.kept.numbers[1].path, "elements.k2.scale");
  EXPECT_EQ(found.kept.numbers[2].si_unit, "kg");
  const double mass = found.kept.numbers[2].given;
  for (const KeptDesign& one : found.kept.list) {
    const Eigen::MatrixXd draws = drawn.draw(one.number, 1);
    EXPECT_NEAR(one.numbers[0], draws(0, 0), round_off);
    EXPECT_NEAR(one.numbers[1], draws(0, 1), round_off);
    EXPECT_NEAR(one.numbers[2], mass * draws(0, 2), round_off * mass);
  }
}

TEST(KeptDesigns, AreTheFirstOnesAndTheFirstThatFail) {
  const study::Sample found = sample_of(3000);
  std::uint64_t first = 0, met = 0;
  std::vector<std::uint64_t> failing;  // by their numbers; the one with the least margin of all may be one more
  for (const KeptDesign& one : found.kept.list) {
    if (one.number < KeptDesigns::first) ++first, met += one.is_met();
    else if (!one.is_met()) failing.push_back(one.number);
  }
  EXPECT_GT(met, 0);
  EXPECT_EQ(first, KeptDesigns::first);
  ASSERT_GE(failing.size(), KeptDesigns::failing);
  ASSERT_LE(failing.size(), KeptDesigns::failing + 1);
  // Samples of as many designs count the same ones.
  EXPECT_EQ(sample_of(KeptDesigns::first).yield.met, met);
  const std::uint64_t to_last = failing[KeptDesigns::failing - 1] + 1;
  EXPECT_EQ(to_last - sample_of(static_cast<int>(to_last)).yield.met, KeptDesigns::first - met + KeptDesigns::failing);
  // The extremes of all designs.
  const auto with = [&](bool KeptDesign::* which) { return *std::ranges::find(found.kept.list, true, which); };
  const KeptDesign worst = with(&KeptDesign::has_least_margin), best = with(&KeptDesign::has_largest);
  EXPECT_EQ(worst.number, found.worst->number);
  EXPECT_DOUBLE_EQ(worst.margins[worst.governing()], found.worst_margin);
  for (const KeptDesign& one : found.kept.list) EXPECT_LE(one.margins[one.governing()], best.margins[best.governing()]);
}

// A mass of which 0.3 % are negative: those designs have no model.
TEST(KeptDesigns, WithoutAModelHaveNoMargins) {
  const study::Sample found = sample_of(4000, {"tolerances.casting.standard_deviation=\"37 %\""});
  ASSERT_GT(found.failed, 0);
  std::size_t unjudged = 0;
  for (const KeptDesign& one : found.kept.list) {
    EXPECT_EQ(one.is_judged(), one.numbers[2] > 0);
    unjudged += !one.is_judged();
    if (!one.is_judged()) {
      EXPECT_FALSE(one.is_met());
    }
  }
  EXPECT_GT(unjudged, 0);
  EXPECT_LE(unjudged, found.failed);
}

}  // namespace unit_kept_designs_test
}  // namespace trivet
