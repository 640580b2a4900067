// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/content.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "trivet/foundation/invalid_input.h"
#include "trivet/results/analyses/study_arrays.h"
#include "trivet/results/format/written_results.h"
#include "trivet/study/analyses/analysis_commands.h"
#include "trivet/study/whole_study.h"

namespace trivet::exports {
namespace {

constexpr const char *of_matrices = "matrices", *of_sample = "sample";

std::vector<std::string> known_names() {
  std::vector<std::string> names = {of_matrices};
  for (const study::AnalysisCommand& analysis : study::analysis_commands()) names.emplace_back(analysis.name);
  names.emplace_back(of_sample);
  return names;
}

/// What the file requests, and the modes.
std::vector<std::string> requested_in(const project::Project& project, const project::Case& variant) {
  const project::Analyses& request = variant.analyses;
  std::vector<std::string> names = {of_matrices, "modes"};
  if (request.roots) names.emplace_back("roots");
  if (request.response) names.emplace_back("response");
  if (request.peaks) names.emplace_back("peaks");
  if (request.static_of) names.emplace_back("static");
  for (const auto& [name, analysis] : project::independent_analyses(request)) names.push_back(name);
  if (!request.limit_lines.empty()) names.emplace_back("limit_lines");
  if (!request.measurements.empty()) names.emplace_back("measurements");
  if (request.sample && &variant == &project.base()) names.emplace_back(of_sample);
  return names;
}

Group matrices(const project::Case& variant, std::vector<std::string>& notes) {
  const auto found = std::make_shared<const study::SystemMatrices>(study::system_matrices(variant));
  if (!found->exact)
    notes.emplace_back(
        "elements depend on frequency: B and K are those of their nearest linear system, the results are exact");
  return {of_matrices, results::matrix_arrays(*found), nullptr, found};
}

Group result_group(const project::Case& variant, const std::string& analysis, const project::Analyses& request,
                   const foundation::Progress& progress) {
  const auto found = std::make_shared<const study::CaseResults>(study::case_results(variant, request, progress));
  const bool only_beside = analysis == "response" && found->response;
  if (!found->failures.empty() && !only_beside) throw foundation::NotComputable(found->failures.front());
  return {analysis, results::result_arrays(analysis, variant, *found), found, found};
}

/// The designs within the tolerances, which are those of all cases: part of the base model.
Group sample(const project::Project& project, const foundation::Progress& progress) {
  const auto found = std::make_shared<study::CaseResults>();
  try {
    found->sample = std::make_shared<const study::Sample>(study::sample_in_a_run(project, false, progress));
  } catch (const foundation::InvalidInput& reason) {  // such as a file without requirements
    throw foundation::NotComputable(reason.what());
  }
  return {of_sample, results::result_arrays(of_sample, project.base(), *found), found, found};
}

std::string left_out(const std::string& name, const std::string& reason) {
  return "left out: " + (reason.starts_with(name + ":") ? "" : name + ": ") + reason;
}

}  // namespace

void require_known(const std::vector<std::string>& what) {
  const std::vector<std::string> known = known_names();
  for (const std::string& name : what) {
    if (std::ranges::find(known, name) != known.end()) continue;
    const std::string guess = foundation::nearest_name(name, known);
    std::string list;
    for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
    throw foundation::InvalidInput("what: \"" + name + "\" is nothing that can be exported; " +
                                   (guess.empty() ? "known are " + list : "did you mean \"" + guess + "\"?"));
  }
}

const Group* Content::find(const std::string& name) const {
  const auto found = std::ranges::find(groups, name, &Group::name);
  return found == groups.end() ? nullptr : &*found;
}

std::string Content::words() const { return project.source + (variant.name.empty() ? "" : ", case " + variant.name); }

Content content(const project::Project& project, const project::Case& variant, const std::vector<std::string>& what,
                const std::vector<std::string>& format_groups, const foundation::Progress& progress) {
  Content found{project, variant, {}, {}};
  const auto request = [&](const std::string& name) {
    return name == of_matrices || name == of_sample ? project::Analyses()
                                                    : study::analysis_command(name).request(variant);
  };
  const auto add = [&](const std::string& name, const project::Analyses& analysis) {
    if (found.find(name)) return;
    found.groups.push_back(name == of_matrices     ? matrices(variant, found.notes)
                               : name == of_sample ? sample(project, progress)
                                                   : result_group(variant, name, analysis, progress));
  };
  for (const std::string& name : what) add(name, request(name));
  if (!what.empty()) return found;
  for (const std::string& name : format_groups.empty() ? requested_in(project, variant) : format_groups) {
    std::optional<project::Analyses> analysis;
    try {
      analysis = request(name);
    } catch (const foundation::InvalidInput& reason) {  // such as a format's result without its excitation
      found.notes.push_back(left_out(name, reason.what()));
      continue;
    }
    try {
      add(name, *analysis);
    } catch (const foundation::NotComputable& reason) {
      found.notes.push_back(left_out(name, reason.what()));
    }
  }
  if (found.groups.empty()) throw foundation::NotComputable(found.notes.front());
  return found;
}

}  // namespace trivet::exports
