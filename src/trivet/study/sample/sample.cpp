// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "trivet/foundation/parallel_for.h"
#include "trivet/study/sample/sample_result.h"
#include "trivet/study/sample/sample_run.h"
#include "trivet/study/sample/sample_shares.h"

namespace trivet::study {

std::optional<double> Yield::deciding(double wanted) const {
  if (met == designs) return std::ceil(std::log(1 - sample_confidence) / std::log(wanted));
  // The interval shrinks as the root of the number of designs.
  const double half = interval.estimate < wanted ? interval.to - interval.estimate : interval.estimate - interval.from,
               needed = static_cast<double>(designs) * std::pow(half / (interval.estimate - wanted), 2);
  if (!(needed < project::most_sampled)) return std::nullopt;
  const double two_digits = std::pow(10.0, std::floor(std::log10(needed)) - 1);
  return (std::floor(needed / two_digits) + 1) * two_digits;
}

bool Sample::any_violates() const {
  if (yield.met < yield.designs) return true;
  return std::ranges::any_of(cases, [](const SampledCaseResult& one) {
    return std::ranges::any_of(one.requirements,
                               [](const SampledRequirement& of) { return of.worst_margin().value_or(1) < 1; });
  });
}

Sample sample(const project::Project& project, const foundation::Progress& progress, const SampleOptions& options) {
  SampleRun run(project);
  const std::size_t wanted = run.request().designs;
  run.keep_first(run.is_quick() ? options.most_by_kernels : options.most_assembled);
  const FirstDesigns first = run.first_designs(progress);
  SampleTally all = run.empty_tally(first.magnitudes);
  first.count_in(run.drawn(), all);
  std::mutex taking;
  std::vector<SampleTally> free;  // tallies of pieces, in any order: bands take long to merge
  foundation::parallel_for(run.request().designs - first.count,
                           {.size = run.piece(), .progress = progress, .task = "designs"},
                           [&](std::size_t from, std::size_t to) {
                             SampleTally part = [&] {
                               const std::lock_guard lock(taking);
                               if (free.empty()) return run.empty_tally(first.magnitudes);
                               SampleTally one = std::move(free.back());
                               free.pop_back();
                               return one;
                             }();
                             run.count(first.count + from, to - from, part);
                             const std::lock_guard lock(taking);
                             free.push_back(std::move(part));
                           });
  for (const SampleTally& part : free) all.merge(part);
  Sample found = sample_result(run, all);
  const bool by_kernels =
      std::ranges::all_of(run.cases(), [](const SampledCase& one) { return one.no_kernels().empty(); });
  found.worst_is_left_out = found.request.worst_case && !by_kernels && !options.worst_of_assembled;
  if (found.request.worst_case && !found.worst_is_left_out) add_worst_designs(run, found, progress);
  if (run.request().designs < wanted) found.first_of = wanted;
  if (options.shares) found.shares = variance_shares(run.cases(), run.tolerances(), run.request(), progress);
  return found;
}

}  // namespace trivet::study
