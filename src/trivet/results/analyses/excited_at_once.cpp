// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "trivet/project/analyses/drive.h"
#include "trivet/results/format/written_answers.h"

namespace trivet::results {
namespace {

/// The excitations that the case selects for a question; empty: all.
std::vector<std::string> selected(const project::Analyses& asked, const std::string& question) {
  if (question == "peaks" && asked.peaks) return asked.peaks->selection.excitations;
  if (const auto* own = asked.find<project::Question>(question)) return own->selection.excitations;
  return (question == "peaks" || question == "response") && asked.response ? asked.response->selection.excitations
                                                                           : std::vector<std::string>();
}

}  // namespace

std::string excited_at_once(const project::Case& variant, const std::string& question) {
  const std::vector<std::string> chosen = selected(variant.analyses, question);
  std::vector<std::string> names;
  for (const model::Excitation& excitation : variant.system.description().excitations) {
    if (model::is_selected(excitation, chosen) && project::drives(excitation, project::drive_of(question)))
      names.push_back(excitation.name);
  }
  return excited_at_once(names);
}

std::string excited_at_once(const std::vector<std::string>& names) {
  if (names.size() < 2) return "";
  return fmt::format("Excited simultaneously by {} (set `excitations` of the analysis to select some)\n",
                     fmt::join(names, ", "));
}

}  // namespace trivet::results
