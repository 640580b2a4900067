// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/overruled_cases.h"

#include <algorithm>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/model_number.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {
namespace {

/// Warnings that a command will refuse these cases, as far as the design has to hold in them.
foundation::Problems warnings_of(const project::Project& project, const std::vector<project::DesignAxis>& axes,
                                 const std::string& command, bool with_requirements) {
  foundation::Problems problems;
  const std::vector<std::string> hold_in = cases_to_hold(project);
  for (const project::Case& variant : project.cases) {
    if (std::ranges::find(hold_in, variant.name) == hold_in.end()) continue;
    if (with_requirements && !variant.analyses.requirements) continue;
    for (const OverruledCase& one : overruled_in(variant, project.base(), axes))
      problems.warning(command, one.finding, "the parameter would undo the case, so " + command + " stops", one.remedy);
  }
  return problems;
}

}  // namespace

std::string OverruledCase::refusal(const std::string& command) const {
  return command + ": " + finding + "; " + remedy;
}

std::vector<OverruledCase> overruled_in(const project::Case& variant, const project::Case& base,
                                        const std::vector<project::DesignAxis>& axes) {
  std::vector<OverruledCase> found;
  for (const project::DesignAxis& axis : axes)
    for (const project::ParameterPlace& place : axis.places) {
      const project::ModelNumber number(place.path, axis.unit);
      if (number.read(variant) == number.read(base)) continue;
      found.push_back(
          {"case " + foundation::quoted(variant.name) + " sets " + place.path + ", which the parameter " +
               foundation::quoted(axis.name) + " moves",
           "change another number in the case, such as stiffness_factor, or leave the case out of hold_in"});
    }
  return found;
}

foundation::Problems overruled_by_search(const project::Project& project) {
  const project::OptimizeRequest request = project.base().analyses.optimize.value_or(project::OptimizeRequest());
  std::vector<project::DesignAxis> axes = project.base().analyses.parameters;
  std::erase_if(axes, [&](const project::DesignAxis& axis) { return !request.varies(axis.name); });
  return warnings_of(project, axes, "optimize", false);
}

foundation::Problems overruled_by_map(const project::Project& project) {
  const auto& request = project.base().analyses.map;
  if (!request) return {};
  std::vector<project::DesignAxis> axes = {request->x, request->y};
  for (std::size_t k = 0; k < request->pairs.size(); ++k) {
    if (k == 0) axes.clear();
    const project::MapRequest one = request->of_pair(k);
    for (const project::DesignAxis* axis : {&one.x, &one.y})
      if (std::ranges::find(axes, axis->name, &project::DesignAxis::name) == axes.end()) axes.push_back(*axis);
  }
  return warnings_of(project, axes, "map", true);  // other cases are no rules of a map that cannot judge them
}

}  // namespace trivet::study
