// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

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

TEST(ShownNumbers, ARatioHasNoLevel) {
  const documents::DisplayUnit ratio = documents::amplitude_unit(inches_peak_to_peak(), "1");
  EXPECT_EQ(ratio.label(), "1");
  EXPECT_EQ(ratio.factor, 1);
  EXPECT_EQ(documents::amplitude_unit(inches_peak_to_peak(), "m/N").level, "");
}

TEST(ShownNumbers, EveryAmplitudeHasItsLevel) {
  EXPECT_EQ(documents::value_text(6.33e-3 * std::sqrt(2), documents::amplitude_unit({}, "m/s")), "6.33 mm/s rms");
  EXPECT_EQ(documents::value_text(1e-4, documents::amplitude_unit({}, "m")), "100 µm 0-p");
  EXPECT_EQ(documents::value_text(60, documents::amplitude_unit({}, "N")), "60 N 0-p");
  EXPECT_EQ(documents::value_text(1e-3, documents::root_mean_square_unit({}, "m/s")), "1 mm/s rms");
}

TEST(ShownNumbers, AmplitudesOfDataAreZeroToPeakUnlessTheDisplayHasALevel) {
  EXPECT_EQ(documents::amplitude_unit_of_data({}, "m/s").label(), "m/s");
  EXPECT_EQ(documents::amplitude_unit_of_data({}, "m/s").factor, 1);
  EXPECT_EQ(documents::amplitude_unit_of_data(inches_peak_to_peak(), "m/s").label(), "in/s p-p");
}

TEST(ShownNumbers, OnlySiUnitsGetAPrefix) {
  const project::DisplayUnits display = inches_peak_to_peak();
  EXPECT_EQ(documents::value_text(2.54e-5, documents::amplitude_unit(display, "m")), "0.002 in p-p");
  EXPECT_EQ(documents::value_text(600, documents::amplitude_unit(display, "N")), "1.2 kN p-p");
  EXPECT_EQ(documents::value_text(0.0005, documents::display_unit({}, "m")), "500 µm");
}

TEST(ShownNumbers, FrequenciesAreInHertzUnlessTheDisplayHasAnotherUnit) {
  EXPECT_EQ(documents::frequency_unit({}), "Hz");
  EXPECT_EQ(documents::frequency_heading({}), "f [Hz]");
  EXPECT_NEAR(documents::shown_frequency({}, 2 * 3.141592653589793), 1, 1e-15);
  project::DisplayUnits display;
  display.frequency = "rad/s";
  EXPECT_EQ(documents::frequency_unit(display), "rad/s");
  EXPECT_EQ(documents::frequency_heading(display), "ω [rad/s]");
  EXPECT_EQ(documents::shown_frequency(display, 3), 3);
  display.frequency = "rpm";
  EXPECT_EQ(documents::frequency_unit(display), "rpm");
  EXPECT_EQ(documents::frequency_heading(display), "f [rpm]");
  EXPECT_NEAR(documents::shown_frequency(display, 3.141592653589793), 30, 1e-12);
}

TEST(ShownNumbers, OnlyNumbersInRadiansPerSecondAreAngularFrequencies) {
  EXPECT_EQ(documents::name_in_unit("angular_frequency", "rad/s"), "angular_frequency");
  EXPECT_EQ(documents::name_in_unit("damped_angular_frequency", "Hz"), "damped_frequency");
  EXPECT_EQ(documents::name_in_unit("at", "rpm"), "at");
}

TEST(ShownNumbers, RoundOffChoosesNoPrefix) {
  documents::LargestOfKind largest;
  largest.add("m", 2e-3);
  EXPECT_EQ(documents::value_text(largest.shown("m", 1e-15), documents::amplitude_unit({}, "m")), "0 m 0-p");
  EXPECT_EQ(documents::value_text(largest.shown("m", 3e-15), documents::amplitude_unit({}, "m")), "3e-06 nm 0-p");
}

}  // namespace shown_numbers_test
