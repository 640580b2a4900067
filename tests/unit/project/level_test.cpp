// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/level.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace level_test {

using namespace trivet;
using project::Level;
using project::Levels;
using project::Quantity;

constexpr double round_off = 1e-15;

/// Root mean square of sin t by the trapezoidal rule, which is exact for it over full turns.
double rms_of_a_sine() {
  constexpr int points = 64;
  double sum = 0;
  for (int i = 0; i < points; ++i) sum += std::pow(std::sin(2 * std::numbers::pi * i / points), 2);
  return std::sqrt(sum / points);
}

TEST(Level, OfASine) {
  EXPECT_NEAR(project::level_factor(Level::rms), rms_of_a_sine(), round_off);
  EXPECT_EQ(project::level_factor(Level::peak_to_peak), 2);  // from −1 to 1
  EXPECT_EQ(project::level_factor(Level::amplitude), 1);
}

TEST(Level, FollowsTheUnit) {
  const auto split = project::split_level(" 4.5 mm/s  rms ");
  EXPECT_EQ(split.number, " 4.5 mm/s");
  EXPECT_EQ(split.level, Level::rms);
  for (const char* text : {"4.5 mm/s", "4.5 mm/srms", "rms", "", "0-p"})
    EXPECT_FALSE(project::split_level(text).level.has_value()) << text;
}

TEST(Level, OfAnAmplitudeIsConverted) {
  for (const auto& [text, amplitude] :
       {std::pair{"4.5 mm/s rms", 4.5e-3 * std::sqrt(2)}, std::pair{"9 mm/s p-p", 4.5e-3},
        std::pair{"4.5 mm/s 0-p", 4.5e-3}, std::pair{"4.5 mm/s", 4.5e-3}})
    EXPECT_NEAR(*project::to_si_at_level(text, Quantity::velocity, Levels::of_harmonic), amplitude,
                round_off * amplitude)
        << text;
  EXPECT_NEAR(*project::to_si_at_level("1 mm p-p", Quantity::length, Levels::of_harmonic, Level::rms),
              1e-3 * rms_of_a_sine() / 2, 1e-18);
}

TEST(Level, OfRandomVibrationIsARootMeanSquare) {
  EXPECT_EQ(*project::to_si_at_level("2 m/s rms", Quantity::velocity, Levels::of_random), 2);
  for (const char* text : {"2 m/s 0-p", "2 m/s p-p"})
    EXPECT_THAT(project::to_si_at_level(text, Quantity::velocity, Levels::of_random).error(),
                testing::HasSubstr("is a root mean square, which"));
}

TEST(Level, OfOtherNumbersIsAnError) {
  EXPECT_THAT(project::to_si_at_level("5 mm rms", Quantity::length, Levels::none).error(),
              testing::HasSubstr("this number is neither"));
  EXPECT_EQ(*project::to_si_at_level("5 m 0-p", Quantity::length, Levels::of_largest), 5);
  EXPECT_FALSE(project::to_si_at_level("5 m rms", Quantity::length, Levels::of_largest).has_value());
}

}  // namespace level_test
