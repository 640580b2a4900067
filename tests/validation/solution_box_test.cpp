// SPDX-License-Identifier: BSD-3-Clause
// Solution boxes against closed forms and a grid of designs that are judged one by one.
#include "trivet/study/box/solution_box.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/results/design/box_document.h"

namespace trivet {
namespace solution_box_test {

constexpr double mass = 10, stiffness = 40000, sag = 3e-3, gravity = 9.80665;
const double omega = 2 * std::numbers::pi * 11;  // highest natural frequency [rad/s]

/// A mass on a spring that may neither sag nor be fast: k ≥ mg/s and k ≤ mω², a wedge in the plane of m and k.
const std::string wedge = [] {
  std::ifstream file(std::string(TRIVET_SOURCE_DIR) + "/tests/data/projects/wedge.toml");
  return std::string(std::istreambuf_iterator<char>(file), {});
}();

constexpr double rubber = 0.15 * stiffness, casting = 0.5;  // half widths
constexpr double exact = 1e-6;                              // of a tolerance: the step with which ends are tried

/// How far the ends that sag together can go, and those that are fast together.
const double of_sag = (stiffness - mass * gravity / sag) / (rubber + casting * gravity / sag);
const double of_frequency = (mass * omega * omega - stiffness) / (rubber + casting * omega * omega);

TEST(SolutionBox, IsTheLargestRectangleOfAWedge) {
  const study::SolutionBox found = study::solution_box(test::project(wedge));
  ASSERT_EQ(found.ranges.size(), 2);
  const study::BoxRange &k = found.ranges[0], &m = found.ranges[1];
  EXPECT_NEAR(k.lower.times, of_sag, exact);
  EXPECT_NEAR(m.upper.times, of_sag, exact);
  EXPECT_NEAR(k.upper.times, of_frequency, exact);
  EXPECT_NEAR(m.lower.times, of_frequency, exact);
  EXPECT_NEAR(found.all_times, std::min(of_sag, of_frequency), exact);
  EXPECT_NEAR(k.numbers[0].from, stiffness - of_sag * rubber, exact * rubber);
  EXPECT_NEAR(m.numbers[0].to, mass + of_sag * casting, exact * casting);
  for (const study::BoxRange& one : found.ranges)
    for (const study::BoxEnd* end : {&one.lower, &one.upper}) {
      EXPECT_EQ(end->stop, study::BoxStop::requirement);
      EXPECT_TRUE(end->is_corner);
      const bool sags = end == &k.lower || end == &m.upper;
      EXPECT_EQ(found.cases[0].requirements[end->requirement].given.kind,
                sags ? study::RequirementKind::static_value : study::RequirementKind::avoided_frequencies);
    }
  EXPECT_TRUE(found.check.all_corners);
  EXPECT_EQ(found.check.corners, 4);
  EXPECT_EQ(found.check.inside, 2000);
  EXPECT_EQ(found.check.models, 4 + 256);
  EXPECT_EQ(found.check.violations, 0);
  EXPECT_EQ(found.check.repeats, 0);
}

// A wider tolerance takes the larger share of the room.
TEST(SolutionBox, HasTheProportionsOfTheTolerances) {
  const study::SolutionBox found = study::solution_box(test::project(wedge, {"tolerances.casting.half_width=1.5"}));
  const double wide = (stiffness - mass * gravity / sag) / (rubber + 3 * casting * gravity / sag);
  EXPECT_NEAR(found.ranges[0].lower.times, wide, exact);
  EXPECT_NEAR(found.ranges[1].upper.draw, wide * 3 * casting, exact);
}

// Each spring has its own draw in the range of its tolerance: the worst are all of them at one end.
TEST(SolutionBox, HasOneRangeForNumbersThatDrawForThemselves) {
  std::string text = wedge;
  const std::string one = "[elements.k1]", path = "path = \"elements.k1.translation.z\"";
  text.replace(text.find("40 N/mm"), 7, "20 N/mm");
  text.replace(text.find(path), path.size(), "path = [\"elements.k1.translation.z\", \"elements.k2.translation.z\"]");
  text += "[elements.k2]\ntype = \"three_springs\"\non = \"m1\"\nat = [0, 0, 0]\ntranslation = [0, 0, 20000]\n";
  const study::SolutionBox found = study::solution_box(test::project(text));
  EXPECT_EQ(found.draws, 3);
  EXPECT_EQ(found.ranges[0].numbers.size(), 2);
  EXPECT_NEAR(found.ranges[0].lower.times, of_sag, exact);
  EXPECT_NEAR(found.ranges[1].lower.times, of_frequency, exact);
}

TEST(SolutionBox, EndsWhereThereIsNoModelAndAtTheLargestRange) {
  const std::string text = test::chain({10}, {40000, 0}, {60, 0}) + R"(
[tolerances.oil]
path = "elements.k1.damping.translation.x"
half_width = "20 %"
[requirements]
natural_frequencies = {avoid = [["11 Hz", "1000 Hz"]]}
[analyses.box]
points = 1000
)";
  const study::SolutionBox found = study::solution_box(test::project(text));
  const study::BoxRange& oil = found.ranges.at(0);
  EXPECT_EQ(oil.lower.stop, study::BoxStop::no_model);
  EXPECT_THAT(oil.lower.reason, testing::HasSubstr("damping"));
  EXPECT_NEAR(oil.numbers[0].from, 0.01 * 60, 1e-9) << "a hundredth of the distance to a damping of 0";
  EXPECT_EQ(oil.upper.stop, study::BoxStop::most);
  EXPECT_DOUBLE_EQ(oil.numbers[0].to, 60 * (1 + 10 * 0.2));
  const study::SolutionBox narrow = study::solution_box(test::project(text, {"analyses.box.most=2"}));
  EXPECT_EQ(narrow.ranges[0].lower.stop, study::BoxStop::most);
  EXPECT_DOUBLE_EQ(narrow.ranges[0].numbers[0].from, 60 * (1 - 2 * 0.2));
}

/// The same machine that may not be in a narrow range of frequencies, 3 mHz wide, and sags by at most 2.6 mm.
std::string narrow_window(bool casting_first) {
  std::string text = wedge;
  const auto change = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  change(R"(["11 Hz", "1000 Hz"])", R"(["10.2 Hz", "10.203 Hz"])");
  change("3 mm", "2.6 mm");
  const std::size_t first = text.find("[tolerances.rubber]"), second = text.find("[tolerances.casting]"),
                    end = text.find("[requirements]");
  if (!casting_first) return text;
  return text.substr(0, first) + text.substr(second, end - second) + text.substr(first, second - first) +
      text.substr(end);
}

const double window = 2 * std::numbers::pi * 10.2;  // [rad/s]

// A box that begins beyond a region of violations contains it, however narrow it is.
TEST(SolutionBox, EndsBeforeANarrowRegionOfViolations) {
  std::string text = narrow_window(false);
  const std::size_t casting = text.find("[tolerances.casting]"), end = text.find("[requirements]");
  text.erase(casting, end - casting);
  const study::SolutionBox found = study::solution_box(test::project(text));
  const study::BoxEnd& upper = found.ranges.at(0).upper;
  EXPECT_NEAR(upper.times, (mass * window * window - stiffness) / rubber, exact);
  EXPECT_EQ(upper.stop, study::BoxStop::requirement);
  ASSERT_EQ(upper.beyond.size(), 1);
  EXPECT_NEAR(upper.beyond[0].value, found.ranges[0].numbers[0].to, 1.01 * exact * rubber) << "one step further";
  EXPECT_NEAR(found.ranges[0].lower.times, (stiffness - mass * gravity / 2.6e-3) / rubber, exact);
  EXPECT_EQ(found.check.repeats, 0);
}

TEST(SolutionBox, HasTheSameEndsForAnyOrderOfTheTolerances) {
  const double slow = (mass * window * window - stiffness) / (rubber + casting * window * window);
  const double sags = (stiffness - mass * gravity / 2.6e-3) / (rubber + casting * gravity / 2.6e-3);
  for (const bool casting_first : {false, true}) {
    const study::SolutionBox found = study::solution_box(test::project(narrow_window(casting_first)));
    const study::BoxRange &k = found.ranges.at(casting_first ? 1 : 0), &m = found.ranges.at(casting_first ? 0 : 1);
    ASSERT_EQ(k.name, "rubber");
    EXPECT_NEAR(k.upper.times, slow, exact);
    EXPECT_NEAR(m.lower.times, slow, exact);
    EXPECT_NEAR(k.lower.times, sags, exact);
    EXPECT_NEAR(m.upper.times, sags, exact);
    for (const study::BoxEnd* end : {&k.lower, &k.upper, &m.lower, &m.upper})
      EXPECT_EQ(end->stop, study::BoxStop::requirement);
  }
}

// The step by which an end is tried changes a requirement by less than its reserve if the number hardly matters.
TEST(SolutionBox, StopsEndsThatHardlyMatterWithTheOthersInAnyOrder) {
  const double weak = 4, of_weak = 0.01 * weak;  // [N/m]
  const double slow = (mass * window * window - stiffness - weak) / (rubber + of_weak);
  const double sags = (stiffness + weak - mass * gravity / 2.6e-3) / (rubber + of_weak);
  for (const bool weak_first : {false, true}) {
    std::string text = narrow_window(false);
    const std::size_t casting = text.find("[tolerances.casting]"), end = text.find("[requirements]");
    text.erase(casting, end - casting);
    text.insert(text.find("[tolerances.rubber]"),
                "[elements.k2]\ntype = \"three_springs\"\non = \"m1\"\nat = [0, 0, 0]\ntranslation = [0, 0, 4]\n");
    text.insert(text.find(weak_first ? "[tolerances.rubber]" : "[requirements]"),
                "[tolerances.weak]\npath = \"elements.k2.translation.z\"\nhalf_width = \"1 %\"\n");
    const study::SolutionBox found = study::solution_box(test::project(text));
    const study::BoxRange &k = found.ranges.at(weak_first ? 1 : 0), &other = found.ranges.at(weak_first ? 0 : 1);
    constexpr double stuck = 1e-4;
    EXPECT_NEAR(k.upper.times, slow, exact);
    EXPECT_NEAR(other.upper.times, slow, stuck);
    EXPECT_NEAR(k.lower.times, sags, exact);
    EXPECT_NEAR(other.lower.times, sags, stuck);
    for (const study::BoxEnd* one : {&k.lower, &k.upper, &other.lower, &other.upper})
      EXPECT_EQ(one->stop, study::BoxStop::requirement);
  }
}

/// Three numbers of two masses; the amplitudes have their largest values at corners and inside.
const std::string pair = test::driven_pair() + R"([tolerances.rubber]
path = "elements.k1.scale"
half_width = "10 %"
[tolerances.oil]
path = "elements.k2.damping.translation.x"
half_width = "20 %"
[tolerances.casting]
path = "bodies.m1.mass"
half_width = "10 %"
[requirements.limits]
"m1.x" = "3 mm"
"m2.x" = {limit = "2 mm", band = ["6.9999999 Hz", "7 Hz"]}
[analyses.box]
points = 5000
most = 3
)";

double least_margin(double k, double c, double m) {
  const auto verdict = study::verdict(
      test::project(pair,
                    {fmt::format("elements.k1.scale={}", k), fmt::format("elements.k2.damping.translation.x={}", c),
                     fmt::format("bodies.m1.mass={}", m)}));
  double least = INFINITY;
  for (const study::RequirementResult& one : verdict.cases[0].results) least = std::min(least, one.margin);
  return least;
}

TEST(SolutionBox, HasNoViolationInsideAndOneBeyondEachEnd) {
  const study::SolutionBox found = study::solution_box(test::project(pair));
  const auto grid_least = [](const std::array<std::array<double, 2>, 3>& ends, int points) {
    const auto at = [&](int d, int i) { return std::lerp(ends[d][0], ends[d][1], i / (points - 1.0)); };
    double least = INFINITY;
    for (int i = 0; i < points; ++i)
      for (int j = 0; j < points; ++j)
        for (int k = 0; k < points; ++k) least = std::min(least, least_margin(at(0, i), at(1, j), at(2, k)));
    return least;
  };
  std::array<std::array<double, 2>, 3> ends;
  for (std::size_t d = 0; d < 3; ++d) ends[d] = {found.ranges[d].numbers[0].from, found.ranges[d].numbers[0].to};
  EXPECT_GE(grid_least(ends, 6), 1);
  int stopped = 0;
  for (std::size_t d = 0; d < 3; ++d)
    for (const bool upper : {false, true}) {
      const study::BoxEnd& end = upper ? found.ranges[d].upper : found.ranges[d].lower;
      if (end.stop != study::BoxStop::requirement) continue;
      ++stopped;
      ASSERT_EQ(end.beyond.size(), 3);
      EXPECT_LT(least_margin(end.beyond[0].value, end.beyond[1].value, end.beyond[2].value), 1)
          << found.ranges[d].name << upper;
    }
  EXPECT_GE(stopped, 3);
}

TEST(SolutionBox, NamesWhatTheDesignOfTheFileViolates) {
  try {
    static_cast<void>(study::solution_box(test::project(wedge, {"requirements.static={\"m1.z\" = \"2 mm\"}"})));
    FAIL();
  } catch (const foundation::NotComputable& refused) {
    EXPECT_THAT(refused.what(),
                testing::HasSubstr("the design of the file violates or only just meets \"at rest m1.z"));
    EXPECT_THAT(refused.what(), testing::HasSubstr("margin 0.81"));
  }
}

TEST(SolutionBox, IsTheSameForAnyNumberOfThreads) {
  const project::Project project = test::project(pair);
  const auto json = [&](int threads) {
    const foundation::ThreadLimit limit(threads);
    const study::SolutionBox found = study::solution_box(project);
    return documents::as_json_text(results::box_document(found, {}));
  };
  const std::string one = json(1);
  EXPECT_EQ(json(2), one);
  EXPECT_EQ(json(3), one);
}

}  // namespace solution_box_test
}  // namespace trivet
