// SPDX-License-Identifier: BSD-3-Clause
// Bands of amplitudes over sampled designs against the closed form of one mass: below the resonances of all designs an
// amplitude falls with the stiffness, so its quantiles are those of a lognormal number.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "support/projects.h"
#include "trivet/study/sample/band_tally.h"
#include "trivet/study/sample/sample.h"

namespace trivet {
namespace sample_bands_test {

constexpr double stiffness = 40000, mass = 10, dashpot = 60, force = 10, of_stiffness = 0.1;

double amplitude(double k, double omega) { return force / std::hypot(k - mass * omega * omega, dashpot * omega); }

/// The stiffness that a share of all does not exceed, z standard deviations from the median.
double stiffness_at(double z) {
  const double variance = std::log1p(of_stiffness * of_stiffness);
  return stiffness * std::exp(-variance / 2 + z * std::sqrt(variance));
}

TEST(SampledBand, HasTheQuantilesOfOneMassBelowItsResonance) {
  const study::Sample found = study::sample(test::project(test::chain({mass}, {stiffness, 0}, {dashpot, 0}) +
                                                          fmt::format(R"(
[excitations.force]
type = "harmonic"
on = "m1"
at = [0, 0, 0]
force = [{}, 0, 0]
[tolerances.rubber]
path = "elements.k1.scale"
standard_deviation = "{} %"
distribution = "lognormal"
[requirements]
limits = {{"m1.x" = "3 mm"}}
[analyses]
response = {{at = ["5 rad/s", "25 rad/s", "40 rad/s"]}}
sample = {{designs = 65536, bands = ["m1.x"]}}
)",
                                                                      force, 100 * of_stiffness)));
  ASSERT_EQ(found.cases[0].bands.size(), 1);
  const study::SampledBand& band = found.cases[0].bands[0];
  EXPECT_EQ(band.no_kernels, "");
  EXPECT_EQ(band.angular_frequency, (std::vector<double>{5, 25, 40}));
  // Half an interval of the histogram, and what 65536 Sobol numbers leave of a quantile in a tail.
  constexpr double within = 1e-3 + 1e-3;
  constexpr double z = 1.6448536269514722;
  for (std::size_t f = 0; f < 3; ++f) {
    const double omega = band.angular_frequency[f];
    EXPECT_NEAR(band.spread[f].low / amplitude(stiffness_at(z), omega), 1, within) << omega;
    EXPECT_NEAR(band.spread[f].median / amplitude(stiffness_at(0), omega), 1, within) << omega;
    EXPECT_NEAR(band.spread[f].high / amplitude(stiffness_at(-z), omega), 1, within) << omega;
    EXPECT_NEAR(band.given[f] / amplitude(stiffness, omega), 1, 1e-12) << omega;
  }
}

// At rest no kernel computes amplitudes: those of models are added to margins that kernels have proven.
TEST(SampledBand, ChangesNeitherTheYieldNorWhoJudges) {
  const std::string text = test::chain({mass}, {stiffness, 0}, {dashpot, 0}) + R"(
[excitations.force]
type = "harmonic"
on = "m1"
at = [0, 0, 0]
force = [10, 0, 0]
[tolerances.rubber]
path = "elements.k1.scale"
standard_deviation = "20 %"
[requirements]
limits = {"m1.x" = "0.3 mm"}
[analyses]
response = {at = ["0 Hz", "5 Hz"]}
)";
  const study::Sample without = study::sample(test::project(text + "sample = {designs = 4096}\n")),
                      with = study::sample(test::project(text + "sample = {designs = 4096, bands = [\"m1.x\"]}\n"));
  EXPECT_NE(with.cases[0].bands.at(0).no_kernels, "");
  EXPECT_EQ(with.cases[0].bands[0].without, 0);
  EXPECT_EQ(with.yield.met, without.yield.met);
  EXPECT_EQ(with.failed, without.failed);
  EXPECT_EQ(with.cases[0].in_kernels, without.cases[0].in_kernels);
  EXPECT_EQ(with.cases[0].one_by_one, without.cases[0].one_by_one);
}

TEST(BandTally, DoesNotCountDesignsWithoutAmplitudes) {
  study::BandTally tally(1);
  tally.add(Eigen::ArrayXd::Constant(1, 2.0), 7);
  tally.add(Eigen::ArrayXd::Constant(1, std::numeric_limits<double>::quiet_NaN()), 8);
  tally.add(Eigen::ArrayXd::Constant(1, 3.0), 9);
  EXPECT_EQ(tally.values()[0].amplitudes.count(), 2);
  EXPECT_EQ(tally.values()[0].extremes.largest, 3.0);
  EXPECT_EQ(tally.values()[0].extremes.largest_at, 9);
}

}  // namespace sample_bands_test
}  // namespace trivet
