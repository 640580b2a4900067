// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "trivet/project/text/display_units.h"

namespace display_units_test {

using namespace trivet;

project::DisplayUnits with(const std::vector<std::pair<std::string, std::string>>& changes) {
  project::DisplayUnits units;
  for (const auto& [key, value] : changes) EXPECT_FALSE(project::set_shown_unit(units, key, value).has_errors());
  return units;
}

TEST(ShownUnit, ReplacesEveryBaseUnitOfAProductOrQuotient) {
  const project::DisplayUnits units = with({{"length", "in"}, {"force", "lbf"}, {"angle", "deg"}});
  constexpr double inch = 0.0254, pound = 4.4482216152605;
  for (const auto& [si, shown, factor] :
       {std::tuple{"m", "in", 1 / inch}, std::tuple{"m/s²", "in/s²", 1 / inch}, std::tuple{"N", "lbf", 1 / pound},
        std::tuple{"N m", "lbf in", 1 / pound / inch}, std::tuple{"rad/s", "deg/s", 180 / 3.141592653589793}}) {
    const project::ShownUnit found = project::shown_unit(units, si);
    EXPECT_EQ(found.unit, shown);
    EXPECT_NEAR(found.factor, factor, 1e-14 * factor);
  }
  EXPECT_EQ(project::shown_unit(units, "1").factor, 1);
  const project::ShownUnit length = project::shown_unit(units, "m");
  for (const auto& [si, words] : {std::pair{"m²/Hz", "{}²/Hz"}, std::pair{"(m/s²)²/(rad/s)", "({}/s²)²/(rad/s)"}}) {
    const project::ShownUnit density = project::shown_unit(units, si);
    EXPECT_EQ(density.unit, fmt::format(fmt::runtime(words), length.unit));
    EXPECT_DOUBLE_EQ(density.factor, length.factor * length.factor);
  }
  EXPECT_EQ(project::shown_unit({}, "m").unit, "m");
}

TEST(ShownUnit, OfFrequenciesAndLevels) {
  EXPECT_NEAR(project::shown_frequency(with({{"frequency", "rpm"}})).factor, 30 / 3.141592653589793, 1e-14);
  EXPECT_EQ(project::shown_frequency({}).unit, "rad/s");
  EXPECT_EQ(project::shown_level(with({{"level", "peak_to_peak"}}), "m/s"), project::Level::peak_to_peak);
  EXPECT_EQ(project::shown_level(with({{"level", "amplitude"}}), "m/s"), project::Level::amplitude);
  EXPECT_EQ(project::shown_level(with({{"level", "rms"}}), "m"), project::Level::rms);
}

TEST(ShownUnit, OfVelocitiesIsRmsUnlessTheDisplayHasALevel) {
  for (const char* unit : {"m/s", "rad/s"}) EXPECT_EQ(project::shown_level({}, unit), project::Level::rms) << unit;
  for (const char* unit : {"m", "m/s²", "rad", "N", "N m"})
    EXPECT_EQ(project::shown_level({}, unit), project::Level::amplitude) << unit;
}

TEST(ShownUnit, OfAnotherQuantityIsRefusedWithARemedy) {
  project::DisplayUnits units;
  for (const auto& [key, value] :
       {std::pair{"length", "s"}, std::pair{"force", "m"}, std::pair{"level", "peak"}, std::pair{"colour", "red"},
        std::pair{"frequency", "N"}, std::pair{"length", ""}, std::pair{"length", "in2/in"}}) {
    const foundation::Problems problems = project::set_shown_unit(units, key, value);
    ASSERT_EQ(problems.errors(), 1u) << key;
    EXPECT_FALSE(problems.list().front().remedy.empty());
  }
  EXPECT_EQ(units, project::DisplayUnits());
}

}  // namespace display_units_test
