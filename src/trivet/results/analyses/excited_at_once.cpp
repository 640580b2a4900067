// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "trivet/project/analyses/drive.h"
#include "trivet/results/format/result_writer.h"

namespace trivet::results {
namespace {

/// The excitations that the case selects for an analysis; empty: all.
std::vector<std::string> selected(const project::Analyses& request, const std::string& analysis) {
  if (analysis == "peaks" && request.peaks) return request.peaks->selection.excitations;
  for (const auto& [name, own] : project::independent_analyses(request))
    if (name == analysis) return own.selection.excitations;
  return (analysis == "peaks" || analysis == "response") && request.response ? request.response->selection.excitations
                                                                             : std::vector<std::string>();
}

}  // namespace

std::vector<std::string> excited_names(const project::Case& variant, const std::string& analysis) {
  const std::vector<std::string> chosen = selected(variant.analyses, analysis);
  std::vector<std::string> names;
  for (const model::Excitation& excitation : variant.system.description().excitations) {
    if (model::is_selected(excitation, chosen) && project::drives(excitation, project::drive_of(analysis)))
      names.push_back(excitation.name);
  }
  return names;
}

Sentence excited_part(const project::Case& variant, const std::string& analysis) {
  return excited_part(excited_names(variant, analysis));
}

Sentence excited_part(const std::vector<std::string>& names) {
  if (names.size() < 2) return {};
  return {.parts = {fmt::format("Excited simultaneously by {} (set `excitations` of the analysis to select some)",
                                fmt::join(names, ", "))},
          .forms = on_screen | on_page};
}

}  // namespace trivet::results
