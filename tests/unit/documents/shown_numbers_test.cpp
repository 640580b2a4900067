// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "trivet/documents/shown_numbers.h"

namespace shown_numbers_test {

using namespace trivet;

constexpr double inch = 0.0254;

project::DisplayUnits inches_peak_to_peak() {
  project::DisplayUnits display;
  display.length = "in";
  display.level = project::Level::peak_to_peak;
  return display;
}

TEST(ShownNumbers, ThousandsHaveNoPowerOfTen) {
  const auto kilograms = documents::display_unit({}, "kg");
  EXPECT_EQ(documents::value_text(12000, kilograms), "12000 kg");
  EXPECT_EQ(documents::value_text(9999.7, kilograms), "10000 kg");  // four digits round it to 1e+04
  EXPECT_EQ(documents::value_text(4200.4, kilograms), "4200 kg");
  EXPECT_EQ(documents::value_text(3e8, kilograms), "3e+08 kg");
}

TEST(ShownNumbers, OnlyHarmonicAmplitudesHaveALevel) {
  const documents::DisplayUnit amplitude = documents::amplitude_unit(inches_peak_to_peak(), "m");
  EXPECT_EQ(amplitude.label(), "in p-p");
  EXPECT_NEAR(amplitude.factor, 2 / inch, 1e-12 / inch);
  const documents::DisplayUnit at_rest = documents::display_unit(inches_peak_to_peak(), "m");
  EXPECT_EQ(at_rest.label(), "in");
  EXPECT_NEAR(at_rest.factor, 1 / inch, 1e-12 / inch);
}

TEST(ShownNumbers, ARatioStays) {
  const documents::DisplayUnit ratio = documents::amplitude_unit(inches_peak_to_peak(), "1");
  EXPECT_EQ(ratio.label(), "1");
  EXPECT_EQ(ratio.factor, 1);
}

TEST(ShownNumbers, OnlySiUnitsGetAPrefix) {
  const project::DisplayUnits display = inches_peak_to_peak();
  EXPECT_EQ(documents::value_text(2.54e-5, documents::amplitude_unit(display, "m")), "0.002 in p-p");
  EXPECT_EQ(documents::value_text(600, documents::amplitude_unit(display, "N")), "1.2 kN p-p");
  EXPECT_EQ(documents::value_text(0.0005, documents::display_unit({}, "m")), "500 µm");
}

TEST(ShownNumbers, FrequenciesAreInHertzUnlessTheDisplayHasAnotherUnit) {
  EXPECT_THAT(documents::frequency_units({}), testing::ElementsAre("Hz"));
  EXPECT_EQ(documents::frequency_heading({}), "f [Hz]");
  EXPECT_NEAR(documents::shown_frequency({}, 2 * 3.141592653589793), 1, 1e-15);
  project::DisplayUnits display;
  display.frequency = "rad/s";
  EXPECT_THAT(documents::frequency_units(display), testing::ElementsAre("rad/s"));
  EXPECT_EQ(documents::frequency_heading(display), "ω [rad/s]");
  EXPECT_EQ(documents::shown_frequency(display, 3), 3);
  display.frequency = "rpm";
  EXPECT_THAT(documents::frequency_units(display), testing::ElementsAre("rpm"));
  EXPECT_EQ(documents::frequency_heading(display), "f [rpm]");
  EXPECT_NEAR(documents::shown_frequency(display, 3.141592653589793), 30, 1e-12);
}

}  // namespace shown_numbers_test
