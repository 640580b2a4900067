// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/intervals.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <vector>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/counter_numbers.h"

namespace intervals_test {

using trivet::numerics::ConfidenceInterval;
using trivet::numerics::mean_of_replicates;
using trivet::numerics::share_of_trials;
using trivet::numerics::share_without_failures;

/// P(at most k successes of n) by the sum of the binomial distribution.
double at_most(int k, int n, double p) {
  double sum = 0;
  for (int i = 0; i <= k; ++i)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) + i * std::log(p) +
                    (n - i) * std::log1p(-p));
  return sum;
}

TEST(ShareOfTrials, EndsWhereTheBinomialDistributionLeavesAFortieth) {
  constexpr double round_off = 1e-11;  // sums of up to 500 terms of lgamma
  for (const auto& [k, n] : {std::pair(1, 10), {5, 10}, {9, 10}, {37, 500}, {499, 500}}) {
    const ConfidenceInterval found = share_of_trials(k, n, 0.95);
    EXPECT_DOUBLE_EQ(found.estimate, static_cast<double>(k) / n);
    EXPECT_NEAR(1 - at_most(k - 1, n, found.from), 0.025, round_off);
    EXPECT_NEAR(at_most(k, n, found.to), 0.025, round_off);
  }
}

// Exact: the sum of the probabilities of all results whose interval contains the share. Near 0 and 1 one result alone
// decides, that without successes or failures.
TEST(ShareOfTrials, ContainsEveryShareWithAtLeastTheConfidence) {
  constexpr double round_off = 1e-11;  // of the sums, at shares just inside an interval
  for (const int n : {1, 2, 10, 100}) {
    std::vector<ConfidenceInterval> intervals;
    std::vector<double> shares = {1e-6, 0.5};
    for (int k = 0; k <= n; ++k) {
      intervals.push_back(share_of_trials(k, n, 0.95));
      for (const double end : {intervals.back().from, intervals.back().to})  // where the coverage is least
        if (end > 0 && end < 1)
          for (const double aside : {-1e-9, 1e-9}) shares.push_back(end * (1 + aside));
    }
    for (const double p : shares) {
      if (p >= 1) continue;
      double covered = 0;
      for (int k = 0; k <= n; ++k)
        if (intervals[k].from <= p && p <= intervals[k].to) covered += at_most(k, n, p) - at_most(k - 1, n, p);
      EXPECT_GE(covered, 0.95 - round_off) << p << " with " << n;
    }
  }
}

TEST(ShareOfTrials, EndsAtZeroAndOneWithoutFailures) {
  const ConfidenceInterval found = share_of_trials(10000, 10000, 0.95), none = share_of_trials(0, 10000, 0.95);
  constexpr double of_power = 1e-12, round_off = 1e-15;  // a last place 10,000 times; one last place
  EXPECT_NEAR(std::pow(found.from, 10000), 0.025, of_power);
  EXPECT_EQ(found.to, 1);
  EXPECT_NEAR(none.to, 1 - found.from, round_off);
  EXPECT_EQ(none.from, 0);
  EXPECT_THROW(static_cast<void>(share_of_trials(3, 2, 0.95)), trivet::foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(share_of_trials(0, 0, 0.95)), trivet::foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(share_of_trials(1, 2, 1)), trivet::foundation::InvalidInput);
}

TEST(ShareWithoutFailures, IsTheRuleOfThree) {
  const double ln_20 = std::log(20);  // 2.996
  EXPECT_NEAR(1 - share_without_failures(10000, 0.95), ln_20 / 10000, ln_20 * ln_20 / 2e8) << "of the next order";
  EXPECT_NEAR(share_without_failures(1, 0.95), 0.05, 1e-15) << "round-off";
  EXPECT_THROW(static_cast<void>(share_without_failures(0, 0.95)), trivet::foundation::InvalidInput);
}

TEST(MeanOfReplicates, HasTheWidthOfStudent) {
  // Mean 3, standard deviation √2.5, t(0.975, 4) = 2.776445.
  const std::array<double, 5> replicates = {1, 2, 3, 4, 5};
  const ConfidenceInterval found = mean_of_replicates(replicates, 0.95);
  EXPECT_NEAR(found.estimate, 3, 1e-14);
  EXPECT_NEAR(found.to - 3, 2.776445 * std::sqrt(2.5 / 5), 1e-6);
  EXPECT_NEAR(found.from + found.to, 6, 1e-14);
  EXPECT_THROW(static_cast<void>(mean_of_replicates(std::span(replicates).first(1), 0.95)),
               trivet::foundation::InvalidInput);
}

}  // namespace intervals_test
