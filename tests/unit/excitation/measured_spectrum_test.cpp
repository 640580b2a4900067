// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/measured_spectrum.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"

namespace measured_spectrum_test {

using namespace trivet;
using namespace trivet::excitation;
using test::RelativelyNear;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double round_off = 1e-11;  // sums of thousands of squares

double mean_square_of(const MeasuredSpectrum& spectrum) { return mean_square(from_table(spectrum.table)); }

// Segments, Parseval: a sine on a line has its power on this line and its two neighbours.
TEST(MeasuredSpectrum, ASineOnALineHasItsMeanSquare) {
  constexpr double step = 1.0 / 256, amplitude = 3;
  std::vector<double> record;
  for (int i = 0; i < 4096; ++i) record.push_back(7 + amplitude * std::sin(two_pi * 20 * i * step + 0.4));
  const MeasuredSpectrum found = measured_spectrum(record, step, 0.5);
  EXPECT_EQ(found.segments, 4096 / 256 - 1);  // the next number of samples above 512 without larger primes is itself
  EXPECT_DOUBLE_EQ(found.resolution_hz, 0.5);
  EXPECT_DOUBLE_EQ(found.table.frequencies_hz.front(), 0.25);  // the first line, at 0.5 Hz, holds from here
  EXPECT_THAT(mean_square_of(found), RelativelyNear(amplitude * amplitude / 2, round_off));
  EXPECT_LT(found.table.densities_per_hz[61], 1e-20);  // 30.5 Hz
}

TEST(MeasuredSpectrum, ToneOnALowLineKeepsItsMeanSquareToo) {
  for (const double hertz : {1.0, 1.5, 126.5}) {  // lines 2, 3 and 253 of 255
    std::vector<double> record;
    for (int i = 0; i < 2048; ++i) record.push_back(std::sin(two_pi * hertz * i / 256));
    EXPECT_THAT(mean_square_of(measured_spectrum(record, 1.0 / 256, 0.5)), RelativelyNear(0.5, round_off)) << hertz;
  }
}

// x_i = a x_(i-1) + e_i has the one-sided density 2 dt σ²/|1 - a exp(-i ω dt)|².
TEST(MeasuredSpectrum, ColouredNoiseHasTheDensityOfItsFilter) {
  constexpr double step = 1e-3, feedback = 0.8;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> record = {0};
  for (int i = 1; i < 400'000; ++i) record.push_back(feedback * record.back() + normal(random));
  const MeasuredSpectrum found = measured_spectrum(record, step, 5);
  ASSERT_LT(found.line_error, 0.04);
  double squares = 0;
  std::size_t lines = 0;
  for (std::size_t i = 2; i + 2 < found.table.frequencies_hz.size(); ++i, ++lines) {
    const double phase = two_pi * found.table.frequencies_hz[i] * step;
    const double exact = 2 * step / (1 + feedback * feedback - 2 * feedback * std::cos(phase));
    const double deviation = found.table.densities_per_hz[i] / exact - 1;
    EXPECT_LT(std::abs(deviation), 6 * found.line_error) << found.table.frequencies_hz[i];
    squares += deviation * deviation;
  }
  // The scatter of the lines is the stated one, to what the number of lines lets us tell.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(lines)) / found.line_error, 1, 0.25);
}

TEST(MeasuredSpectrum, ALineEveryThirdOfAHertzHasSegmentsWithoutLargePrimes) {
  const MeasuredSpectrum found = measured_spectrum(std::vector<double>(5000, 1.5), 0.01, 1 / 3.01);  // 301 samples
  EXPECT_NEAR(found.resolution_hz, 1 / 3.2, 1e-15);                                                  // 320 samples
  for (const double density : found.table.densities_per_hz) EXPECT_EQ(density, 0);
}

TEST(MeasuredSpectrum, ARecordThatIsTooShortOrTooCoarseIsRefused) {
  EXPECT_THROW((void)measured_spectrum(std::vector<double>(99, 1), 0.01, 1), foundation::InvalidInput);
  EXPECT_NO_THROW((void)measured_spectrum(std::vector<double>(100, 1), 0.01, 1));
  EXPECT_THROW((void)measured_spectrum(std::vector<double>(100, 1), 0.01, 20), foundation::InvalidInput);
  EXPECT_THROW((void)measured_spectrum(std::vector<double>(100, 1), 0.01, 1e-30), foundation::InvalidInput);
}

}  // namespace measured_spectrum_test
