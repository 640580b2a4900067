// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "trivet/study/analyses/case_results.h"

namespace trivet::study {
namespace {

template <typename Compared>
std::vector<const Compared*> alone(const std::vector<Compared>& list, const CaseResults& results, auto judges) {
  std::vector<const Compared*> found;
  for (const Compared& one : list)
    if (!results.verdict || std::ranges::none_of(results.verdict->results, [&](const RequirementResult& requirement) {
          return judges(requirement, one);
        }))
      found.push_back(&one);
  return found;
}

}  // namespace

std::vector<const LimitResult*> limits_alone(const CaseResults& results) {
  return alone(results.limits, results, [](const RequirementResult& requirement, const LimitResult& limit) {
    return requirement.kind == RequirementKind::amplitude && requirement.subject == limit.name;
  });
}

std::vector<const LimitLineResult*> limit_lines_alone(const CaseResults& results) {
  return alone(results.limit_lines, results, [](const RequirementResult& requirement, const LimitLineResult& line) {
    const RequirementKind kind = line.bands.empty() ? RequirementKind::limit_line : RequirementKind::band_line;
    return requirement.kind == kind && requirement.subject == line.of && requirement.line == line.line.name;
  });
}

std::vector<const OperatingLine*> operating_lines_alone(const CaseResults& results) {
  if (!results.operation) return {};
  return alone(results.operation->lines, results, [](const RequirementResult& requirement, const OperatingLine& line) {
    return requirement.kind == RequirementKind::band_line && requirement.subject == line.of &&
        requirement.line == line.line.name;
  });
}

}  // namespace trivet::study
