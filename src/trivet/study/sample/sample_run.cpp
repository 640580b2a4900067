// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"

namespace trivet::study {
namespace {

constexpr std::size_t most_first_designs = 120;  // which set the units of the sums

const std::vector<project::Tolerance>& given_tolerances(const project::Project& project) {
  const project::Analyses& analyses = project.base().analyses;
  if (analyses.tolerances.empty())
    throw foundation::InvalidInput(
        "sample: the file has no tolerances; write [tolerances.NAME] with path and half_width");
  return analyses.tolerances;
}

}  // namespace

SampleRun::SampleRun(const project::Project& project)
    : project_(project),
      request_(project.base().analyses.sample.value_or(project::SampleRequest())),
      tolerances_(given_tolerances(project)),
      drawn_(tolerances_, request_) {
  const std::vector<std::string> hold_in = cases_to_hold(project);
  for (const project::Case& variant : project.cases)
    if (std::ranges::find(hold_in, variant.name) != hold_in.end())
      cases_.emplace_back(variant, tolerances_, drawn_, request_);
  const bool any = std::ranges::any_of(cases_, [](const SampledCase& one) { return !one.given().empty(); });
  if (!any)
    throw foundation::InvalidInput(
        "sample: neither requirements nor limits; a yield is the share of designs that meet them: add "
        "[requirements]");
}

bool SampleRun::is_quick() const { return std::ranges::all_of(cases_, &SampledCase::is_quick); }

std::size_t SampleRun::piece() const { return is_quick() ? SampledCase::kernel_piece : SampledCase::model_piece; }

void FirstDesigns::count_in(const DrawnDesigns& drawn, SampleTally& tally) const {
  for (std::size_t i = 0; i < margins.size(); ++i) tally.add(drawn, i * piece, margins[i]);
}

FirstDesigns SampleRun::first_designs(const foundation::Progress& progress) const {
  FirstDesigns first{.count = std::min(most_first_designs, request_.designs), .piece = SampledCase::model_piece};
  first.margins.resize((first.count + SampledCase::model_piece - 1) / SampledCase::model_piece);
  foundation::parallel_for(first.count,
                           {.size = SampledCase::model_piece, .progress = progress, .task = "first designs"},
                           [&](std::size_t from, std::size_t to) {
                             first.margins[from / SampledCase::model_piece] = judged(from, to - from, {});
                           });
  first.magnitudes = magnitudes_of(first.margins);
  return first;
}

SampleTally SampleRun::empty_tally(const SampleMagnitudes& magnitudes) const {
  return {cases_, drawn_.replicates(), magnitudes};
}

void SampleRun::count(std::uint64_t first, std::uint64_t number, SampleTally& into,
                      const foundation::Progress& interruption) const {
  const std::uint64_t step = piece(), end = first + number;
  for (std::uint64_t from = first; from < end; from += step)
    into.add(drawn_, from, judged(from, std::min(step, end - from), interruption));
}

std::vector<SampledMargins> SampleRun::judged(std::uint64_t first, std::size_t count,
                                              const foundation::Progress& interruption) const {
  const Eigen::MatrixXd draws = drawn_.draw(first, count);
  std::vector<SampledMargins> margins;
  for (const SampledCase& one : cases_) margins.push_back(one.judged_with_bands(draws, interruption));
  return margins;
}

std::vector<double> SampleRun::margins(std::uint64_t design) const {
  return margins_of_design(judged(design, 1, {}), 0);
}

SampleMagnitudes SampleRun::magnitudes_of(const std::vector<std::vector<SampledMargins>>& first) const {
  SampleMagnitudes all(cases_.size());
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

}  // namespace trivet::study
