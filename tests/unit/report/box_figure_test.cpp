// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/box_figure.h"

#include <gmock/gmock.h>

#include <regex>
#include <string>
#include <vector>

namespace box_figure_test {

using namespace trivet;
using testing::HasSubstr;
using testing::Not;

/// Ranges with these ends in units of the tolerance, to both sides.
study::SolutionBox box(const std::vector<double>& ends) {
  study::SolutionBox found;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    study::BoxRange range{.name = "t" + std::to_string(i)};
    range.lower.times = range.upper.times = ends[i];
    range.numbers = {{.path = "elements.k.scale", .si = "1", .given = 1, .from = 0.9, .to = 1.1}};
    found.ranges.push_back(std::move(range));
  }
  return found;
}

/// Widths of the bars.
std::vector<double> bars(const std::string& svg) {
  std::vector<double> widths;
  const std::regex bar(R"re(<rect x="[\d.]+" y="[\d.]+" width="([\d.]+)" height="16\.00")re");
  for (std::sregex_iterator at(svg.begin(), svg.end(), bar), end; at != end; ++at)
    widths.push_back(std::stod((*at)[1]));
  return widths;
}

TEST(BoxFigure, DrawsTheWidthsOfTheRanges) {
  const std::string svg = report::box_figure(box({1, 2, 3}), "machine").svg;
  const std::vector<double> widths = bars(svg);
  ASSERT_EQ(widths.size(), 3);
  constexpr double printed = 0.02;  // pixels
  EXPECT_NEAR(widths[1], 2 * widths[0], printed);
  EXPECT_NEAR(widths[2], 3 * widths[0], printed);
  EXPECT_THAT(svg, Not(HasSubstr("beyond the picture")));
}

TEST(BoxFigure, OfOneFarEndStillShowsTheOthers) {
  const std::vector<double> near = bars(report::box_figure(box({1, 2, 4}), "machine").svg);
  const std::string svg = report::box_figure(box({1, 1, 400}), "machine").svg;
  const std::vector<double> widths = bars(svg);
  ASSERT_EQ(widths.size(), 3);
  constexpr double printed = 0.02;  // pixels
  EXPECT_NEAR(widths[0], near[0], printed);
  EXPECT_NEAR(widths[2], 4 * widths[0], printed);
  EXPECT_THAT(svg, HasSubstr("arrow: the range goes on beyond the picture"));
}

TEST(BoxFigure, OfOneRangeCutsAFarEnd) {
  study::SolutionBox one = box({1});
  one.ranges.front().upper.times = 400;
  const std::string svg = report::box_figure(one, "machine").svg;
  EXPECT_THAT(svg, HasSubstr("arrow: the range goes on beyond the picture"));
  const double middle = bars(report::box_figure(box({1}), "machine").svg)[0];
  EXPECT_GT(bars(svg)[0], 0.5 * middle);
}

}  // namespace box_figure_test
