// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/intervals.h"

#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <string>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/student_distribution.h"

namespace trivet::numerics {
namespace {

namespace policies = boost::math::policies;
/// Plain double arithmetic, equal on all processors.
using BetaDistribution = boost::math::beta_distribution<double, policies::policy<policies::promote_double<false>>>;

void require(std::uint64_t successes, std::uint64_t trials, double confidence) {
  if (trials < 1 || successes > trials || !(confidence > 0 && confidence < 1))
    throw foundation::InvalidInput(std::to_string(successes) + " of " + std::to_string(trials) +
                                   " trials with a confidence of " + std::to_string(confidence) +
                                   ": at least one trial, and a confidence between 0 and 1");
}

}  // namespace

ConfidenceInterval share_of_trials(std::uint64_t successes, std::uint64_t trials, double confidence) {
  require(successes, trials, confidence);
  const auto good = static_cast<double>(successes), bad = static_cast<double>(trials - successes);
  ConfidenceInterval found{good / (good + bad), 0, 1};
  const double outside = (1 - confidence) / 2;
  if (bad == 0) found.from = std::exp(std::log(outside) / good);
  else if (good > 0) found.from = quantile(BetaDistribution(good, bad + 1), outside);
  if (good == 0) found.to = -std::expm1(std::log(outside) / bad);
  else if (bad > 0) found.to = quantile(complement(BetaDistribution(good + 1, bad), outside));
  return found;
}

double share_without_failures(std::uint64_t trials, double confidence) {
  require(trials, trials, confidence);
  return std::exp(std::log1p(-confidence) / static_cast<double>(trials));
}

ConfidenceInterval mean_of_replicates(std::span<const double> replicates, double confidence) {
  if (replicates.size() < 2)
    throw foundation::InvalidInput(std::to_string(replicates.size()) + " replicates: an interval needs two");
  const auto count = static_cast<double>(replicates.size());
  double mean = 0, squares = 0;
  for (const double one : replicates) mean += one / count;
  for (const double one : replicates) squares += (one - mean) * (one - mean);
  const double half = student_quantile(confidence, count - 1) * std::sqrt(squares / (count - 1) / count);
  return {mean, mean - half, mean + half};
}

}  // namespace trivet::numerics
