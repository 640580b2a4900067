// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/study/sample/sample_shares.h"
#include "trivet/study/sample/sample_tally.h"
#include "trivet/study/sample/worst_case.h"

namespace trivet::study {
namespace {

constexpr std::size_t kernel_piece = 120, model_piece = 8;  // designs
constexpr std::size_t first_designs = 120;                  // which set the units of the sums

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
  yield.of_replicates = designs.size() > 1 && yield.met >= enough && all - yield.met >= enough;
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

Spread spread_of_margin(const RequirementTally& tally) {
  const numerics::Extremes& ends = tally.extremes;  // the middle of an interval of the histogram may be beyond them
  const auto at = [&](double share) {
    const double found = tally.margins.quantile(share);
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
  SampledRequirement found{given, yield_of(tally.met, designs), tally.first, spread_of_margin(tally)};
  found.value = spread_of_value(given, found.margin);
  if (!found.value || tally.values.saturated() || tally.squares.saturated()) return found;
  const auto count = static_cast<double>(judged);
  found.mean = tally.values.value() / count;
  found.deviation = std::sqrt(std::max(0.0, tally.squares.value() / count - *found.mean * *found.mean));
  return found;
}

/// The study while it runs.
class Study {
 public:
  Study(const project::Project& project, Sample& found)
      : project_(project), found_(found), drawn_(found.tolerances, found.request) {
    const std::vector<std::string> hold_in = cases_to_hold(project);
    for (const project::Case& variant : project.cases)
      if (std::ranges::find(hold_in, variant.name) != hold_in.end())
        cases_.emplace_back(variant, found.tolerances, drawn_);
    const bool any = std::ranges::any_of(cases_, [](const SampledCase& one) { return !one.given().empty(); });
    if (!any)
      throw foundation::InvalidInput(
          "sample: neither requirements nor limits; a yield is the share of designs that meet them: add "
          "[requirements]");
    found.draws = drawn_.draws();
    found.replicates = drawn_.replicates();
  }

  void run(const foundation::Progress& progress) {
    // The first designs set the units of the sums.
    const std::size_t count = found_.request.designs, begin = std::min(first_designs, count);
    std::vector<std::vector<SampledMargins>> first((begin + model_piece - 1) / model_piece);
    foundation::parallel_for(
        begin, {.size = model_piece, .progress = progress, .task = "first designs"},
        [&](std::size_t from, std::size_t to) { first[from / model_piece] = judged(from, to - from); });
    const auto magnitudes = magnitudes_of(first);
    SampleTally all(cases_, drawn_.replicates(), magnitudes);
    for (std::size_t i = 0; i < first.size(); ++i) all.add(drawn_, i * model_piece, first[i]);
    const bool kernels = std::ranges::all_of(cases_, [](const SampledCase& one) { return one.no_kernels().empty(); });
    std::mutex merging;
    foundation::parallel_for(count - begin,
                             {.size = kernels ? kernel_piece : model_piece, .progress = progress, .task = "designs"},
                             [&](std::size_t from, std::size_t to) {
                               SampleTally part(cases_, drawn_.replicates(), magnitudes);
                               part.add(drawn_, begin + from, judged(begin + from, to - from));
                               const std::lock_guard lock(merging);
                               all.merge(part);
                             });
    set_results(all);
  }

  [[nodiscard]] const std::vector<SampledCase>& cases() const { return cases_; }

  void search_worst(const foundation::Progress& progress) {
    const WorstSearch search = worst_search(cases_, drawn_, found_.request.seed, progress);
    found_.worst_case_search = {search.all_corners, search.corners, search.inside, search.failed, search.first_failure};
    for (std::size_t c = 0; c < search.of.size(); ++c)
      for (std::size_t r = 0; r < search.of[c].size(); ++r) {
        const WorstFound& one = search.of[c][r];
        found_.cases[c].requirements[r].worst = {one.margin, numbers(one.draws), one.is_corner,
                                                 one.ended,  one.at_ends,        one.looked_at};
      }
  }

 private:
  [[nodiscard]] std::vector<SampledMargins> judged(std::uint64_t first, std::size_t count) const {
    const Eigen::MatrixXd draws = drawn_.draw(first, count);
    std::vector<SampledMargins> margins;
    for (const SampledCase& one : cases_) margins.push_back(one.judged(draws));
    return margins;
  }

  /// @param first  pieces of designs, each with the margins of all cases
  [[nodiscard]] std::vector<std::vector<SumMagnitudes>> magnitudes_of(
      const std::vector<std::vector<SampledMargins>>& first) const {
    std::vector<std::vector<SumMagnitudes>> all(cases_.size());
    for (std::size_t c = 0; c < cases_.size(); ++c)
      for (std::size_t r = 0; r < cases_[c].given().size(); ++r) {
        double largest = 0;
        for (const std::vector<SampledMargins>& piece : first)
          for (const double margin : piece[c].margins.col(to_index(r)))
            if (const auto value = value_at_margin(cases_[c].given()[r], margin); value && std::isfinite(*value))
              largest = std::max(largest, std::abs(*value));
        const double square = largest * largest;
        const bool usable = square > std::numeric_limits<double>::min() && std::isfinite(square);
        all[c].push_back(usable ? SumMagnitudes{largest, square} : SumMagnitudes{});
      }
    return all;
  }

  [[nodiscard]] NamedDesign named(std::uint64_t number) const {
    return {number, numbers(drawn_.draw(number, 1).row(0).transpose())};
  }

  [[nodiscard]] std::vector<NamedNumber> numbers(const Eigen::VectorXd& draws) const {
    std::vector<NamedNumber> list;
    for (std::size_t t = 0; t < found_.tolerances.size(); ++t) {
      const project::Tolerance& tolerance = found_.tolerances[t];
      for (std::size_t p = 0; p < tolerance.places.size(); ++p) {
        const std::string& path = tolerance.places[p].path;
        const double given = project::ModelNumber(path, "").read(project_.base()).value_or(0);
        list.push_back({path, tolerance.number(p, given, draws(to_index(drawn_.draw_of(t, p)))),
                        project::quantity_at(project_.base().document, project::path_keys(path))});
      }
    }
    return list;
  }

  void set_results(const SampleTally& all) {
    const std::uint64_t judged = sum(all.designs) - all.failed;
    found_.yield = yield_of(all.met, all.designs);
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      const SampledCase& one = cases_[c];
      SampledCaseResult result{one.variant().name, one.variant().display, {},
                               all.in_kernels[c],  all.one_by_one[c],     one.no_kernels()};
      if (one.no_kernels().empty()) result.family = one.batch()->family().words();
      for (std::size_t r = 0; r < one.given().size(); ++r)
        result.requirements.push_back(requirement_of(one.given()[r], all.of[c][r], all.designs, judged));
      found_.cases.push_back(std::move(result));
    }
    found_.failed = all.failed;
    if (all.failed > 0) {
      found_.first_failed = named(all.first_failed);
      found_.first_failure = all.first_failure;
    }
    if (all.least.any) {
      found_.worst = named(all.least.least_at);
      found_.worst_margin = all.least.least;
      for (std::size_t c = cases_.size(); c-- > 0;)  // the first of equal ones
        if (std::ranges::any_of(all.of[c], [&](const RequirementTally& one) {
              return one.extremes.any && one.extremes.least == all.least.least &&
                  one.extremes.least_at == all.least.least_at;
            }))
          found_.worst_case = cases_[c].variant().name;
    }
  }

  const project::Project& project_;
  Sample& found_;
  DrawnDesigns drawn_;
  std::vector<SampledCase> cases_;
};

}  // namespace

Sample sample(const project::Project& project, const foundation::Progress& progress, bool shares) {
  const project::Analyses& analyses = project.base().analyses;
  if (analyses.tolerances.empty())
    throw foundation::InvalidInput(
        "sample: the file has no tolerances; write [tolerances.NAME] with path and half_width");
  Sample found;
  found.request = analyses.sample.value_or(project::SampleRequest());
  found.tolerances = analyses.tolerances;
  Study study(project, found);
  study.run(progress);
  if (found.request.worst_case) study.search_worst(progress);
  if (shares) found.shares = variance_shares(study.cases(), found.tolerances, found.request, progress);
  return found;
}

}  // namespace trivet::study
