// SPDX-License-Identifier: BSD-3-Clause
// Yields of sampled designs against closed forms: a lognormal stiffness and mass give a lognormal natural frequency.
#include "trivet/study/sample/sample.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/projects.h"

namespace trivet {
namespace sample_test {

constexpr double stiffness = 40000, mass = 10, of_stiffness = 0.15, of_mass = 0.05;  // relative deviations
const double least_frequency = 0.93 * std::sqrt(stiffness / mass);                   // [rad/s]

double normal_share(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }

/// ln(k/m) is normal: the logarithms have the variances ln(1 + v²) and the means −½ of it.
struct OfLogarithm {
  double k = std::log1p(of_stiffness * of_stiffness), m = std::log1p(of_mass * of_mass);
  [[nodiscard]] double mean() const { return std::log(stiffness / mass) - k / 2 + m / 2; }
  [[nodiscard]] double deviation() const { return std::sqrt(k + m); }
  /// Share of designs with ω above the least one.
  [[nodiscard]] double yield() const {
    return 1 - normal_share((2 * std::log(least_frequency) - mean()) / deviation());
  }
};

std::string oscillator(const std::string& sampling, int designs) {
  return test::chain({mass}, {stiffness, 0}, {0, 0}) +
      fmt::format(R"(
[tolerances.rubber]
path = "elements.k1.scale"
standard_deviation = "{} %"
distribution = "lognormal"
[tolerances.casting]
path = "bodies.m1.mass"
standard_deviation = "{} %"
distribution = "lognormal"
[requirements]
natural_frequencies = {{avoid = [[0, {}]]}}
[analyses.sample]
designs = {}
sampling = "{}"
)",
                  100 * of_stiffness, 100 * of_mass, least_frequency, designs, sampling);
}

TEST(Sample, HasTheYieldOfALognormalFrequency) {
  const study::Sample found = study::sample(test::project(oscillator("sobol", 65536)));
  const double exact = OfLogarithm().yield();
  ASSERT_EQ(found.cases.size(), 1);
  EXPECT_EQ(found.cases[0].no_kernels, "");
  EXPECT_EQ(found.cases[0].in_kernels, 65536 - found.cases[0].one_by_one);
  EXPECT_LT(found.cases[0].one_by_one, 65536 * 1e-4) << "only designs in tails";
  EXPECT_EQ(found.failed, 0);
  EXPECT_TRUE(found.yield.of_replicates);
  // The standard deviation of as many random designs is 1.4e-3 or less.
  EXPECT_NEAR(found.yield.interval.estimate, exact, 1e-3);
  EXPECT_LT(found.yield.interval.to - found.yield.interval.from, 2e-3) << "16 times narrower than of random designs";
}

TEST(Sample, HasTheQuantilesOfALognormalFrequency) {
  // The margin of an avoided band from 0 is ω over its end.
  const study::Sample found = study::sample(test::project(oscillator("sobol", 65536)));
  const OfLogarithm exact;
  const auto quantile = [&](double z) {
    return std::exp((exact.mean() + z * exact.deviation()) / 2) / least_frequency;
  };
  const study::Spread& margin = found.cases[0].requirements[0].margin;
  // Of the histogram, and of 65536 designs in the tails: of random ones the quantile of 5 % has the standard deviation
  // 0.079·√(0.05·0.95)/(0.103·√65536) = 0.07 %.
  constexpr double within = 1e-3 + 1e-3;
  EXPECT_NEAR(margin.low / quantile(-1.6448536), 1, within);
  EXPECT_NEAR(margin.median / quantile(0), 1, within);
  EXPECT_NEAR(margin.high / quantile(1.6448536), 1, within);
}

/// How many of 200 seeds have the exact yield within their interval.
int covered(const std::string& sampling) {
  project::Project project = test::project(oscillator(sampling, 2000));
  const double exact = OfLogarithm().yield();
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    project.cases.front().analyses.sample->seed = seed;
    const study::Sample found = study::sample(project);
    EXPECT_EQ(found.yield.of_replicates, sampling == "sobol");
    count += found.yield.interval.from <= exact && exact <= found.yield.interval.to;
  }
  return count;
}

// With a confidence of exactly 95 %, 190 ± 3.1 (one standard deviation of the binomial distribution) of 200 are
// covered.
constexpr double three_deviations = 9.3;

TEST(Sample, HasReplicateIntervalsThatContainTheYieldAsOftenAsStated) {
  const int found = covered("sobol");
  RecordProperty("covered", found);
  EXPECT_NEAR(found, 190, three_deviations);
}

TEST(Sample, HasIntervalsOfRandomDesignsThatContainTheYieldAtLeastAsOftenAsStated) {
  const int found = covered("random");
  RecordProperty("covered", found);
  EXPECT_GE(found, 190 - three_deviations);
}

TEST(Sample, StatesABoundWithoutViolations) {
  const std::string text = oscillator("sobol", 10000);
  const study::Sample found = study::sample(test::project(text, {"requirements.natural_frequencies.avoid=[[0, 1]]"}));
  EXPECT_EQ(found.yield.met, 10000);
  constexpr double of_power = 1e-12;  // a last place 10,000 times
  EXPECT_NEAR(std::pow(found.yield.interval.from, 10000), 0.025, of_power) << "one side of two";
  EXPECT_EQ(found.yield.interval.to, 1);
}

// Two numbers with one draw for both, or a correlation of nearly 1, give a ratio that does not vary.
TEST(Sample, CorrelatesTolerances) {
  const std::string text = oscillator("sobol", 4096);
  const double v = 0.05;
  const auto deviation = [&](const std::vector<std::string>& settings) {
    const study::Sample found = study::sample(test::project(text, settings));
    const study::Spread& margin = found.cases[0].requirements[0].margin;
    return std::log(margin.high / margin.low) / (2 * 1.6448536);  // of ln ω
  };
  const std::string same = fmt::format("tolerances.rubber.standard_deviation=\"{} %\"", 100 * v);
  constexpr double within = 1e-3;  // of the histogram: 1e-3 of two margins, over 3.3 deviations, and 4096 designs
  EXPECT_NEAR(deviation({same}), v / std::sqrt(2), within);
  EXPECT_NEAR(deviation({same, R"(tolerances.rubber.correlation={with = "casting", value = 0.5})"}), v / 2, within);
  EXPECT_NEAR(deviation({same, R"(tolerances.rubber.correlation={with = "casting", value = -0.5})"}),
              v * std::sqrt(3) / 2, within);
}

// The sag m g/k of a lognormal mass and stiffness: 1/k has the relative variance of k, and the variance of a product of
// independent numbers is (1 + v_k²)(1 + v_m²) − 1 of the squared mean.
TEST(Sample, HasTheVarianceSharesOfASag) {
  const double k = 0.2 * 0.2, m = 0.1 * 0.1, all = (1 + k) * (1 + m) - 1;
  const std::string text = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m1]
mass = 10
free = ["z"]
[elements.k1]
type = "three_springs"
on = "m1"
at = [0, 0, 0]
translation = [0, 0, 40000]
[tolerances.rubber]
path = "elements.k1.scale"
standard_deviation = "20 %"
distribution = "lognormal"
[tolerances.casting]
path = "bodies.m1.mass"
standard_deviation = "10 %"
distribution = "lognormal"
[requirements]
static = {"m1.z" = "4 mm"}
[analyses.sample]
designs = 40_000
)";
  for (const char* sampling : {"sobol", "random"}) {
    const project::Project project = test::project(text, {std::string("analyses.sample.sampling=") + sampling});
    const study::Sample found = study::sample(project, {}, {.shares = true});
    ASSERT_TRUE(found.shares);
    EXPECT_EQ(found.shares->reason, "");
    EXPECT_EQ(found.shares->pairs, 10000);
    EXPECT_EQ(found.shares->left_out, 0);
    EXPECT_THAT(found.shares->names,
                testing::ElementsAre(testing::Field(&study::DrawnName::tolerance, "rubber"),
                                     testing::Field(&study::DrawnName::tolerance, "casting")));
    ASSERT_EQ(found.shares->list.size(), 1);
    const std::vector<numerics::VarianceShare>& draws = found.shares->list.front().draws;
    const double exact[2][2] = {{k / all, k * (1 + m) / all}, {m / all, m * (1 + k) / all}};
    for (std::size_t d = 0; d < 2; ++d)
      for (const auto& [interval, value] :
           {std::pair(draws[d].first, exact[d][0]), std::pair(draws[d].total, exact[d][1])}) {
        const double half = (interval.to - interval.from) / 2;  // 2.13 standard deviations; twice it: 1 in 1000
        EXPECT_NEAR(interval.estimate, value, 2 * half) << sampling << " " << d;
        EXPECT_LT(half, std::string(sampling) == "sobol" ? 0.01 : 0.04);
      }
  }
}

TEST(Sample, HasNoSharesOfCorrelatedTolerances) {
  const study::Sample found = study::sample(
      test::project(oscillator("sobol", 1000), {R"(tolerances.rubber.correlation={with = "casting", value = 0.5})"}),
      {}, {.shares = true});
  EXPECT_EQ(found.shares->reason,
            "\"rubber\" and \"casting\" are correlated, and shares are those of independent numbers");
  EXPECT_TRUE(found.shares->list.empty());
}

}  // namespace sample_test
}  // namespace trivet
