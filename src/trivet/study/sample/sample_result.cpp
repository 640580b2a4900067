// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample_result.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/study/sample/named_numbers.h"
#include "trivet/study/sample/worst_case.h"

namespace trivet::study {
namespace {

/// Fewer met or violated designs per replicate say too little of their differences.
constexpr std::uint64_t fewest_per_replicate = 10;

std::uint64_t sum(const std::vector<std::uint64_t>& list) {
  std::uint64_t all = 0;
  for (const std::uint64_t one : list) all += one;
  return all;
}

Yield yield_of(const std::vector<std::uint64_t>& met, const std::vector<std::uint64_t>& designs) {
  Yield yield;
  yield.met = sum(met);
  yield.designs = sum(designs);
  const std::uint64_t all = yield.designs, enough = fewest_per_replicate * designs.size();
  const bool has_all = std::ranges::all_of(designs, [](std::uint64_t one) { return one > 0; });  // or it has few chunks
  yield.of_replicates = has_all && designs.size() > 1 && yield.met >= enough && all - yield.met >= enough;
  if (!yield.of_replicates) {
    yield.interval = numerics::share_of_trials(yield.met, all, sample_confidence);
    return yield;
  }
  std::vector<double> shares;
  for (std::size_t r = 0; r < designs.size(); ++r)
    shares.push_back(static_cast<double>(met[r]) / static_cast<double>(designs[r]));
  yield.interval = numerics::mean_of_replicates(shares, sample_confidence);
  yield.interval.estimate = static_cast<double>(yield.met) / static_cast<double>(all);
  return yield;
}

/// The middle of an interval of the histogram may be beyond the extremes.
Spread spread_of(const numerics::LogHistogram& numbers, const numerics::Extremes& ends) {
  const auto at = [&](double share) {
    const double found = numbers.quantile(share);
    return ends.any ? std::clamp(found, ends.least, ends.largest) : found;
  };
  return {at(0.05), at(0.5), at(0.95), ends};
}

/// The spread of the values that belong to margins; where more is worse the largest margin has the least value.
std::optional<Spread> spread_of_value(const RequirementResult& given, const Spread& margin) {
  const auto at = [&](double of_margin) { return value_at_margin(given, of_margin); };
  const numerics::Extremes& ends = margin.extremes;
  if (!ends.any || !at(ends.least)) return std::nullopt;
  Spread spread{*at(margin.low),
                *at(margin.median),
                *at(margin.high),
                {*at(ends.least), *at(ends.largest), ends.least_at, ends.largest_at, true}};
  if (*at(2) > *at(1)) return spread;
  std::swap(spread.low, spread.high);
  std::swap(spread.extremes.least, spread.extremes.largest);
  std::swap(spread.extremes.least_at, spread.extremes.largest_at);
  return spread;
}

SampledRequirement requirement_of(const RequirementResult& given, const RequirementTally& tally,
                                  const std::vector<std::uint64_t>& designs, std::uint64_t judged) {
  SampledRequirement found{given, yield_of(tally.met, designs), tally.first, spread_of(tally.margins, tally.extremes)};
  found.value = spread_of_value(given, found.margin);
  if (!found.value || tally.values.saturated() || tally.squares.saturated()) return found;
  const auto count = static_cast<double>(judged);
  found.mean = tally.values.value() / count;
  found.deviation = std::sqrt(std::max(0.0, tally.squares.value() / count - *found.mean * *found.mean));
  return found;
}

std::vector<SampledBand> bands_of(const SampledCase& of, const BandTally& tally, std::uint64_t judged) {
  std::vector<SampledBand> bands = of.bands()->empty(of.given());
  auto value = tally.values().begin();
  for (SampledBand& band : bands) {
    band.without = judged - value->amplitudes.count();
    for (std::size_t f = 0; f < band.angular_frequency.size(); ++f, ++value)
      band.spread.push_back(spread_of(value->amplitudes, value->extremes));
  }
  return bands;
}

std::vector<NamedNumber> numbers(const SampleRun& run, const Eigen::VectorXd& draws) {
  return named_numbers(run.project(), run.tolerances(), run.drawn(), draws);
}

NamedDesign named(const SampleRun& run, std::uint64_t number) {
  return {number, numbers(run, run.drawn().draw(number, 1).row(0).transpose())};
}

}  // namespace

Sample sample_result(const SampleRun& run, const SampleTally& all) {
  Sample found;
  found.request = run.request();
  found.tolerances = run.tolerances();
  found.draws = run.drawn().draws();
  found.replicates = run.drawn().replicates();
  const std::vector<SampledCase>& cases = run.cases();
  const std::uint64_t judged = sum(all.designs) - all.failed;
  found.yield = yield_of(all.met, all.designs);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const SampledCase& one = cases[c];
    SampledCaseResult result{.case_name = one.variant().name,
                             .display = one.variant().display,
                             .in_kernels = all.in_kernels[c],
                             .one_by_one = all.one_by_one[c],
                             .no_kernels = one.no_kernels()};
    if (one.no_kernels().empty()) result.family = one.batch()->family().words();
    for (std::size_t r = 0; r < one.given().size(); ++r)
      result.requirements.push_back(requirement_of(one.given()[r], all.of[c][r], all.designs, judged));
    if (one.bands()) result.bands = bands_of(one, all.bands[c], judged);
    found.cases.push_back(std::move(result));
  }
  found.failed = all.failed;
  if (all.failed > 0) {
    found.first_failed = named(run, all.first_failed);
    found.first_failure = all.first_failure;
  }
  if (all.least.any) {
    found.worst = named(run, all.least.least_at);
    found.worst_margin = all.least.least;
    for (std::size_t c = cases.size(); c-- > 0;)  // the first of equal ones
      if (std::ranges::any_of(all.of[c], [&](const RequirementTally& one) {
            return one.extremes.any && one.extremes.least == all.least.least &&
                one.extremes.least_at == all.least.least_at;
          }))
        found.worst_case = cases[c].variant().name;
  }
  found.kept = kept_designs(run, all);
  return found;
}

void add_worst_designs(const SampleRun& run, Sample& found, const foundation::Progress& progress) {
  WorstStarts drawn;
  for (const SampledCaseResult& one : found.cases) {
    drawn.emplace_back();
    for (const SampledRequirement& of : one.requirements) {
      const numerics::Extremes& ends = of.margin.extremes;
      drawn.back().emplace_back();
      if (ends.any) drawn.back().back().emplace_back(run.drawn().draw(ends.least_at, 1).row(0).transpose());
    }
  }
  const WorstSearch search = worst_search(run.cases(), worst_box(run.drawn()), drawn, run.request().seed, progress);
  found.worst_case_search = {search.all_corners, search.corners, search.inside, search.failed, search.first_failure};
  for (std::size_t c = 0; c < search.of.size(); ++c)
    for (std::size_t r = 0; r < search.of[c].size(); ++r) {
      const WorstFound& one = search.of[c][r];
      found.cases[c].requirements[r].worst = {
          one.margin, numbers(run, one.draws), one.is_corner, one.ended, one.at_ends, one.looked_at};
    }
}

}  // namespace trivet::study
