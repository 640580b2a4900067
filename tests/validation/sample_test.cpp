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

std::vector<std::string> names(const study::SampledShares& shares) {
  std::vector<std::string> list;
  for (const study::DrawnSet& one : shares.sets) list.push_back(one.name.words());
  return list;
}

// The sag m g/k of a lognormal mass and stiffness: 1/k has the relative variance of k, and the variance of a product of
// independent numbers is (1 + v_k²)(1 + v_m²) − 1 of the squared mean.
TEST(Sample, HasTheVarianceSharesOfASag) {
  const double k = 0.2 * 0.2, m = 0.1 * 0.1, all = (1 + k) * (1 + m) - 1;
  const std::string text = test::sagging_mass() + R"(
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
    EXPECT_THAT(names(*found.shares), testing::ElementsAre("rubber", "casting"));
    ASSERT_EQ(found.shares->list.size(), 1);
    const std::vector<numerics::VarianceShare>& draws = found.shares->list.front().sets;
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

// The sag of the last of masses in a row is linear in all masses: Σ m_j g c_j with c_j = 1/k_1 + … + 1/k_j. Correlated
// masses have one share, that of the variance of their sum; those of a batch have one each and one of all.
TEST(Sample, HasTheSharesOfCorrelatedTolerancesAndOfAllNumbersOfOne) {
  const std::vector<double> masses = {10, 4, 6, 3}, springs = {40000, 20000, 30000, 25000},
                            deviations = {1.5, 0.9, 0.1 * 6, 0.1 * 3};
  constexpr double correlation = -0.6;
  const std::string text = test::chain(masses, springs, {}) + R"(
[tolerances.first]
path = "bodies.m1.mass"
standard_deviation = "1.5 kg"
correlation = {with = "second", value = -0.6}
[tolerances.second]
path = "bodies.m2.mass"
standard_deviation = "0.9 kg"
[tolerances.batch]
path = ["bodies.m3.mass", "bodies.m4.mass"]
standard_deviation = "10 %"
[requirements]
static = {"m4.x" = "30 mm"}
)";
  const study::Sample found = study::sample(
      test::project(text, {"gravity=[9.80665, 0, 0]", "analyses.sample.designs=60_000"}), {}, {.shares = true});
  EXPECT_THAT(names(*found.shares),
              testing::ElementsAre("first, second (correlated)", "batch (all 2 numbers)", "batch at bodies.m3.mass",
                                   "batch at bodies.m4.mass"));
  EXPECT_EQ(found.shares->pairs, 10000);
  double compliance = 0;
  std::vector<double> parts;
  for (std::size_t j = 0; j < masses.size(); ++j) parts.push_back(deviations[j] * (compliance += 1 / springs[j]));
  const double pair = parts[0] * parts[0] + parts[1] * parts[1] + 2 * correlation * parts[0] * parts[1];
  const double third = parts[2] * parts[2], fourth = parts[3] * parts[3], all = pair + third + fourth;
  const std::vector<double> exact = {pair / all, (third + fourth) / all, third / all, fourth / all};
  ASSERT_EQ(found.shares->list.size(), 1);
  const std::vector<numerics::VarianceShare>& sets = found.shares->list.front().sets;
  ASSERT_EQ(sets.size(), exact.size());
  for (std::size_t s = 0; s < exact.size(); ++s)
    for (const numerics::ConfidenceInterval& interval : {sets[s].first, sets[s].total}) {
      const double half = (interval.to - interval.from) / 2;
      EXPECT_NEAR(interval.estimate, exact[s], 2 * half) << s;
      EXPECT_LT(half, 0.01);
    }
}

}  // namespace sample_test
}  // namespace trivet
