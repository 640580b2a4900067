// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/shown_case.h"

#include <algorithm>

#include "trivet/foundation/message_list.h"

namespace trivet::report {

std::string ShownCase::name() const { return results.case_name.empty() ? "Base model" : results.case_name; }

std::vector<std::string> ShownCase::failed_checks() const { return results::failed_checks(checks, results); }

std::vector<foundation::Problem> ShownCase::warnings() const {
  foundation::Problems found;
  for (const foundation::Problem& problem : results.warnings.list())
    if (problem.severity == foundation::Severity::warning) found.add(problem);
  std::vector<foundation::Problem> list = foundation::listed(found).list();
  if (const std::string rest = foundation::rest_of_list(found); !rest.empty())
    list.push_back({foundation::Severity::warning, {}, rest, "", "", ""});
  return list;
}

std::size_t ShownCase::limits() const {
  return limits_alone(results).size() + limit_lines_alone(results).size() + operating_lines_alone(results).size();
}

std::size_t ShownCase::exceeded_limits() const {
  const auto limits = limits_alone(results);
  const auto lines = limit_lines_alone(results);
  const auto at_speeds = operating_lines_alone(results);
  return static_cast<std::size_t>(std::ranges::count_if(limits, [](const auto* l) { return !l->met; }) +
                                  std::ranges::count_if(lines, [](const auto* l) { return !l->comparison.met(); }) +
                                  std::ranges::count_if(at_speeds, [](const auto* l) { return !l->met(); }));
}

bool ShownCase::grows() const {
  const auto& modes = results.modes.list;
  const auto& roots = results.roots.list;
  return (variant.analyses.modes && std::ranges::any_of(modes, [](const auto& m) { return !m.angular_frequency; })) ||
      (variant.analyses.roots &&
       std::ranges::any_of(roots, [](const auto& r) { return r.kind == modal::RootKind::growing; }));
}

std::vector<ShownCase> shown_cases(const project::Project& project, const std::vector<study::CaseResults>& results) {
  std::vector<ShownCase> shown;
  for (std::size_t i = 0; i < results.size(); ++i)
    shown.push_back({project.cases[i], results[i], study::check_lines(project.cases[i])});
  return shown;
}

}  // namespace trivet::report
