// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/frequency_bands.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"

namespace frequency_bands_test {

using namespace trivet::excitation;
using ::testing::ElementsAre;
using trivet::test::RelativelyNear;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double round_off = 1e-14;    // a power and a few products
constexpr double closed_form = 1e-12;  // sums and powers of a spectrum in closed form

std::vector<double> nominal(const std::vector<FrequencyBand>& bands) {
  std::vector<double> names;
  for (const FrequencyBand& band : bands) names.push_back(band.nominal_hz());
  return names;
}

// IEC 61260-1, 5.2 … 5.5: G = 10^(3/10), f_m = 1000 Hz G^(x/b), edges f_m G^(±1/(2b)).
TEST(FrequencyBands, MidbandsAndEdgesFollowTheFormulasOfTheStandard) {
  const double ratio = std::pow(10, 0.3);
  for (int x = -60; x <= 20; ++x) {
    const FrequencyBand third{BandWidth::third_octave, 30 + x}, octave{BandWidth::octave, 10 + x};
    EXPECT_THAT(third.midband_hz(), RelativelyNear(1000 * std::pow(ratio, x / 3.0), round_off));
    EXPECT_THAT(third.from() / two_pi, RelativelyNear(1000 * std::pow(ratio, x / 3.0 - 1 / 6.0), round_off));
    EXPECT_THAT(third.to() / two_pi, RelativelyNear(1000 * std::pow(ratio, x / 3.0 + 1 / 6.0), round_off));
    EXPECT_THAT(octave.midband_hz(), RelativelyNear(1000 * std::pow(ratio, x), round_off));
    EXPECT_THAT(octave.from() / two_pi, RelativelyNear(1000 * std::pow(ratio, x - 0.5), round_off));
    EXPECT_THAT(octave.to() / two_pi, RelativelyNear(1000 * std::pow(ratio, x + 0.5), round_off));
  }
}

TEST(FrequencyBands, NamesAreThoseOfTheStandard) {
  EXPECT_THAT(nominal(bands_between(BandWidth::third_octave, two_pi * 0.95, two_pi * 85)),
              ElementsAre(1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8, 10, 12.5, 16, 20, 25, 31.5, 40, 50, 63, 80));
  EXPECT_THAT(nominal(bands_between(BandWidth::octave, two_pi * 0.8, two_pi * 1100)),
              ElementsAre(1, 2, 4, 8, 16, 31.5, 63, 125, 250, 500, 1000));
  EXPECT_THAT(nominal(bands_between(BandWidth::third_octave, two_pi * 0.19, two_pi * 0.35)),
              ElementsAre(0.2, 0.25, 0.315));
}

TEST(FrequencyBands, NeighboursShareOneEdgeToTheLastDigit) {
  for (const BandWidth width : {BandWidth::octave, BandWidth::third_octave})
    for (int index = -40; index < 40; ++index)
      EXPECT_EQ((FrequencyBand{width, index}.to()), (FrequencyBand{width, index + 1}.from()));
}

TEST(FrequencyBands, ARangeFromEdgeToEdgeHasNoBandBeside) {
  const FrequencyBand first{BandWidth::third_octave, 0}, last{BandWidth::third_octave, 19};
  const auto bands = bands_between(BandWidth::third_octave, first.from(), last.to());
  EXPECT_EQ(bands.size(), 20U);
  EXPECT_EQ(bands.front(), first);
  EXPECT_EQ(bands.back(), last);
  EXPECT_EQ(bands_between(BandWidth::octave, 0, two_pi).front().nominal_hz(), 0.125);
}

TEST(FrequencyBands, AToneOnAnEdgeIsInTheUpperBand) {
  for (const BandWidth width : {BandWidth::octave, BandWidth::third_octave})
    for (int index = -20; index <= 40; ++index) {
      const FrequencyBand band{width, index}, above{width, index + 1};
      EXPECT_EQ(band_of_tone(width, band.to()), above) << index;
      EXPECT_EQ(band_of_tone(width, band.to() * (1 - 1e-12)), above) << "round-off, " << index;
      EXPECT_EQ(band_of_tone(width, band.to() * (1 - 1e-8)), band) << index;
      EXPECT_EQ(band_of_tone(width, two_pi * band.midband_hz()), band) << index;
    }
}

TEST(FrequencyBands, ABandIsFoundByNominalAndByExactFrequencyOnly) {
  EXPECT_EQ(band_of(BandWidth::third_octave, 31.5)->index, 15);
  EXPECT_EQ(band_of(BandWidth::third_octave, 31.622776)->index, 15);
  EXPECT_EQ(band_of(BandWidth::octave, 31.5)->index, 5);
  EXPECT_FALSE(band_of(BandWidth::third_octave, 12));
  EXPECT_FALSE(band_of(BandWidth::octave, 20));
  EXPECT_FALSE(band_of(BandWidth::octave, 0));
}

TEST(FrequencyBands, LevelsReturnFromTheirSpectrumAndFromItsDerivative) {
  const auto bands = bands_between(BandWidth::third_octave, two_pi * 0.95, two_pi * 85);
  std::vector<double> levels;
  for (std::size_t i = 0; i < bands.size(); ++i) levels.push_back(i == 3 ? 0 : 1e-6 * (1 + std::sin(double(i))) + 1e-7);
  const Spectrum velocity = spectrum_of_levels(bands, levels);
  const Spectrum again = differentiated(differentiated(velocity, -1), 1);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    for (const Spectrum& spectrum : {velocity, again})
      EXPECT_NEAR(std::sqrt(mean_square(spectrum, bands[i].from(), bands[i].to())), levels[i], closed_form * levels[i]);
  }
}

TEST(FrequencyBands, PartsOfASpectrumHaveItsDensityAndAddUp) {
  SpectrumTable table{{1, 10, 50, 80}, {1e-3, 4e-2, 4e-2, 0}};
  const Spectrum whole = differentiated(from_table(table), 1);
  double sum = 0;
  for (const FrequencyBand& band : bands_between(BandWidth::third_octave, whole.from(), whole.to())) {
    const Spectrum part = in_range(whole, band.from(), band.to());
    const double inside = 0.5 * (part.from() + part.to());
    EXPECT_THAT(density(part, inside), RelativelyNear(density(whole, inside), closed_form));
    EXPECT_THAT(mean_square(part), RelativelyNear(mean_square(whole, band.from(), band.to()), closed_form));
    sum += mean_square(part);
  }
  EXPECT_THAT(sum, RelativelyNear(mean_square(whole), closed_form));
}

}  // namespace frequency_bands_test
