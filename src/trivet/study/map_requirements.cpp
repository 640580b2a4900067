// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map_requirements.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/study/case_context.h"
#include "trivet/study/margin.h"
#include "trivet/study/requirement_values.h"

namespace trivet::study {
namespace {

std::vector<RequirementResult> judged(const project::Analyses& asked, const model::System& system,
                                      foundation::Problems& warnings) {
  if (!asked.requirements || asked.requirements->is_empty()) return {};
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  return requirement_values(context, asked, warnings);
}

}  // namespace

MapRequirements::MapRequirements(const project::Case& variant, const project::MapRequest& request, bool by_matrices)
    : separate_(variant.analyses) {
  separate_.limits.clear();  // rules of the map, or replaced by those
  separate_.requirements = request.requirements;
  if (by_matrices && separate_.requirements) {
    project::Requirements& frequencies = frequencies_.requirements.emplace();
    frequencies.avoided = std::exchange(separate_.requirements->avoided, {});
    frequencies.separation = std::exchange(separate_.requirements->separation, 0);
  }
  add_rules(judged(separate_, variant.system, warnings_));
  first_by_matrices_ = rules_.size();
  add_rules(judged(frequencies_, variant.system, warnings_));
}

void MapRequirements::add_rules(const std::vector<RequirementResult>& results) {
  for (const RequirementResult& result : results)
    rules_.push_back({design::DesignRule::Kind::requirement, result.subject, result.unit, result.allowed, result.words,
                      name(result.kind)});
}

std::vector<RequirementResult> MapRequirements::separate_results(const model::System& system) const {
  foundation::Problems of_design;  // the warnings of the model itself are enough
  return judged(separate_, system, of_design);
}

std::vector<RequirementResult> MapRequirements::results(const model::System& system) const {
  foundation::Problems of_design;
  std::vector<RequirementResult> all = judged(separate_, system, of_design);
  std::vector<RequirementResult> frequencies = judged(frequencies_, system, of_design);
  std::move(frequencies.begin(), frequencies.end(), std::back_inserter(all));
  return all;
}

std::vector<double> MapRequirements::frequency_margins(const Eigen::ArrayXd& squared_frequencies) const {
  if (!frequencies_.requirements) return {};
  std::vector<double> frequencies, margins;
  for (const double squared : squared_frequencies)
    if (squared > 0) frequencies.push_back(std::sqrt(squared));
  for (const response::Band& window : frequencies_.requirements->avoided) {
    double least = foundation::infinity;
    for (const double omega : frequencies) least = std::min(least, margin_outside(window, omega));
    margins.push_back(least);
  }
  if (const double separation = frequencies_.requirements->separation; separation > 0) {
    double least = foundation::infinity;
    for (std::size_t i = 0; i + 1 < frequencies.size(); ++i)
      least = std::min(least, margin_of_least(separation, frequencies[i + 1] / frequencies[i]));
    margins.push_back(least);
  }
  return margins;
}

}  // namespace trivet::study
