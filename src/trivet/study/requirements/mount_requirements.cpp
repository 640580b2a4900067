// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/study/explain/explanation.h"
#include "trivet/study/requirements/mount_loads.h"

namespace trivet::study {
namespace {

void note_idle_limit(const std::string& element, const std::string& limit, const std::string& excitation,
                     RequirementList& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    RequirementResult& result = list[i];
    if (result.kind != RequirementKind::mount_load || result.subject != element) continue;
    result.detail += fmt::format("{}its {} deflection limit is not judged: no {} excitation",
                                 result.detail.empty() ? "" : "; ", limit, excitation);
    return;
  }
}

/// Limits of one kind of motion along the axes of the catalogue mounts; without an excitation that causes it, a note
/// on the first requirement of each mount that has such a limit.
std::vector<project::AmplitudeLimit> deflection_limits(const CaseContext& c, const project::Analyses& analyses,
                                                       bool shock, RequirementList& list) {
  const bool driven = project::is_driven(c.system, shock ? project::Drive::time : project::Drive::harmonic) ||
      (shock && analyses.transient);
  std::vector<project::AmplitudeLimit> limits;
  for (const model::Element& element : c.system.elements()) {
    if (!element.rating) continue;
    const auto& allowed = shock ? element.rating->shock_deflection : element.rating->dynamic_deflection;
    if (allowed && driven)
      limits.push_back({element.name + deflection_along_axis, assembly::MotionQuantity::displacement, *allowed});
    else if (allowed)
      note_idle_limit(element.name, shock ? "shock" : "dynamic", shock ? "transient" : "harmonic", list);
  }
  return limits;
}

/// Adds requirements without values. @return number of the first one in the list
std::size_t add_limits(RequirementKind kind, const std::vector<project::AmplitudeLimit>& limits,
                       const std::string& verb, RequirementList& list) {
  const std::size_t first = list.size();
  for (const project::AmplitudeLimit& limit : limits) {
    const std::string element = limit.name.substr(0, limit.name.rfind(deflection_along_axis));
    list.add(kind, element, {element + " " + verb, "≤ " + value_words(limit.amplitude, "m")}, "m", limit.amplitude);
  }
  return first;
}

}  // namespace

void add_mount_requirements(const CaseContext& context, const project::Analyses& analyses,
                            foundation::Problems& warnings, RequirementList& list) {
  list.append(mount_loads(context));
  if (const auto limits = deflection_limits(context, analyses, false, list); !limits.empty()) {
    const std::size_t first = add_limits(RequirementKind::mount_dynamic_deflection, limits, "vibrates by", list);
    set_amplitudes(context, analyses, first, limits, list);
  }
  if (const auto limits = deflection_limits(context, analyses, true, list); !limits.empty()) {
    const std::size_t first =
        add_limits(RequirementKind::mount_shock_deflection, limits, "deflects over the transient by", list);
    list.attempt(first, [&] { set_largest(context, analyses, warnings, first, limits, list); });
  }
}

}  // namespace trivet::study
