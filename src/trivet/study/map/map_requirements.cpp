// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_requirements.h"

#include <iterator>
#include <utility>

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

std::vector<RequirementResult> judged(const project::Analyses& request, const model::System& system,
                                      foundation::Problems& warnings) {
  const bool required = request.requirements && !request.requirements->is_empty();
  if (!required && system.description().clearances.empty() && !judges_operation(request)) return {};
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  return requirement_values(context, request, warnings);
}

/// Windows without natural frequencies and their separation alone.
std::vector<RequirementResult> judged_frequencies(const project::Requirements& required, const model::System& system) {
  if (required.is_empty()) return {};
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  RequirementList list;
  add_frequency_requirements(context, required, list);
  return list.release();
}

}  // namespace

MapRequirements::MapRequirements(const project::Case& variant, const project::MapRequest& request, bool by_matrices)
    : separate_(variant.analyses) {
  separate_.limits.clear();                                           // rules of the map, or replaced by those
  if (!variant.analyses.requirements) separate_.limit_lines.clear();  // no rules of a map
  separate_.requirements = request.requirements;
  if (by_matrices && separate_.requirements) {
    frequencies_.avoided = std::exchange(separate_.requirements->avoided, {});
    frequencies_.separation = std::exchange(separate_.requirements->separation, 0);
  }
  add_rules(judged(separate_, variant.system, warnings_));
  first_by_matrices_ = rules_.size();
  add_rules(judged_frequencies(frequencies_, variant.system));
}

void MapRequirements::add_rules(const std::vector<RequirementResult>& results) {
  for (const RequirementResult& result : results) {
    rules_.push_back({design::DesignRule::Kind::requirement, result.subject, result.unit, result.allowed,
                      result.words.text(), name(result.kind)});
    rules_.back().words_at_level = result.words_at_level();
    rules_.back().level = result.level();
  }
}

std::vector<RequirementResult> MapRequirements::separate_results(const model::System& system) const {
  foundation::Problems of_design;  // the warnings of the model itself are enough
  return judged(separate_, system, of_design);
}

std::vector<RequirementResult> MapRequirements::results(const model::System& system) const {
  foundation::Problems of_design;
  std::vector<RequirementResult> all = judged(separate_, system, of_design);
  std::vector<RequirementResult> frequencies = frequency_results(system);
  std::move(frequencies.begin(), frequencies.end(), std::back_inserter(all));
  return all;
}

std::vector<RequirementResult> MapRequirements::frequency_results(const model::System& system) const {
  return judged_frequencies(frequencies_, system);
}

std::vector<RequirementResult> MapRequirements::frequencies(const project::MapRequest& request,
                                                            const model::System& system) {
  project::Requirements alone;
  if (request.requirements) {
    alone.avoided = request.requirements->avoided;
    alone.separation = request.requirements->separation;
  }
  return judged_frequencies(alone, system);
}

}  // namespace trivet::study
