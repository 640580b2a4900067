// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/analysis_commands.h"

#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/study/analyses/analysis_run.h"
#include "trivet/study/analyses/curve_results.h"

namespace trivet::study {
namespace {

using project::Analyses;
using project::Case;

Analyses modes_of(const Case& variant) {
  Analyses request;
  request.modes = true;
  request.lowest_modes = variant.analyses.lowest_modes;
  return request;
}

Analyses roots_of(const Case&) {
  Analyses request;
  request.roots = true;
  return request;
}

/// @throws foundation::InvalidInput if the model has no excitation of the kind that the analysis needs
void require_excitation(const std::string& analysis, const Case& variant) {
  const project::Drive drive = project::drive_of(analysis);
  if (drive == project::Drive::none || project::is_driven(variant.system, drive)) return;
  const project::MissingExcitation missing = project::missing_excitation(drive);
  throw foundation::InvalidInput(analysis + ": " + missing.finding + "; this analysis needs one; " + missing.remedy);
}

Analyses response_of(const Case& variant) {
  require_excitation("response", variant);
  Analyses request;
  request.response = variant.analyses.response.value_or(project::ResponseRequest{});
  request.limits = variant.analyses.limits;
  request.lowest_modes = project::modes_beside_a_response;
  if (request.response->at.empty())
    for (const project::LimitLineRequest& line : variant.analyses.limit_lines)
      if (!line.bands) request.limit_lines.push_back(line);  // lines are compared over a band
  return request;
}

Analyses peaks_of(const Case& variant) {
  require_excitation("peaks", variant);
  const Analyses& file = variant.analyses;
  Analyses request;
  request.peaks = file.peaks.value_or(
      project::PeaksRequest{file.response ? file.response->selection : project::ChannelSelection{}});
  return request;
}

Analyses static_of(const Case& variant) {
  std::vector<std::string> all = {"coordinates"};
  for (const auto& element : variant.system.elements()) all.push_back(element.name);
  all.push_back("ground");
  Analyses request;
  request.static_of = variant.analyses.static_of.value_or(all);
  request.all_rest_states = variant.analyses.all_rest_states;
  request.load_sharing = variant.system.description().gravity.has_value();
  return request;
}

/// The analysis of the file; if it has none, the analysis with defaults.
Analyses own_request(const AnalysisRun& analysis, const Case& variant) {
  Analyses request;
  if (analysis.request(variant.analyses, request)) return request;
  if (analysis.to_add) throw foundation::InvalidInput(analysis.to_add);
  require_excitation(analysis.name, variant);
  return request;
}

Analyses limit_lines_of(const Case& variant) {
  if (variant.analyses.limit_lines.empty())
    throw foundation::InvalidInput(
        "limit_lines: none given; add [limit_lines.NAME] with of = \"BODY.z\" and rows = [[10, 2e-3], [60, 2e-3]]");
  const auto& lines = variant.analyses.limit_lines;
  Analyses request;
  if (std::ranges::any_of(lines, [](const project::LimitLineRequest& line) { return !line.bands; })) {
    request = response_of(variant);
    request.response->at.clear();
  }
  request.limit_lines = lines;
  if (variant.analyses.operation && variant.analyses.operation->has_lines())  // tones act besides random vibration
    request.operation = variant.analyses.operation;
  return request;
}

Analyses measurements_of(const Case& variant) {
  if (variant.analyses.measurements.empty())
    throw foundation::InvalidInput(
        "measurements: none given; add [measurements.NAME] with file = \"frf.uff\" and a response to [analyses]");
  Analyses request;
  request.response = variant.analyses.response;
  request.measurements = variant.analyses.measurements;
  return request;
}

/// All coordinates and points, and the forces on the ground if an element ends there.
std::vector<std::string> all_motions(const model::Description& d) {
  std::vector<std::string> all = {"coordinates"};
  for (const model::Body& body : d.bodies)
    for (const model::Point& point : body.points) all.push_back(body.name + "." + point.name);
  const auto on_ground = [](const model::Element& element) { return !element.n.body && !element.is_foundation; };
  if (std::ranges::any_of(d.elements, on_ground)) all.emplace_back("ground");
  return all;
}

}  // namespace

Analyses curve_request(const Case& variant) {
  Analyses request = response_of(variant);
  project::ResponseRequest& response = *request.response;
  response.at.clear();
  response.spacing = project::Spacing::automatic;
  std::vector<std::string>& of = response.selection.of;
  std::vector<std::string> more = all_motions(variant.system.description());
  for (const project::Limit& limit : request.limits) more.push_back(limit.name);
  for (std::string& word : more)
    if (std::ranges::find(of, word) == of.end()) of.push_back(std::move(word));
  request.peaks = project::PeaksRequest{response.selection};
  request.lowest_modes = 0;
  request.limit_lines = variant.analyses.limit_lines;
  std::erase_if(request.limit_lines, [](const project::LimitLineRequest& line) { return line.bands.has_value(); });
  return request;
}

const std::vector<AnalysisCommand>& analysis_commands() {
  static const std::vector<AnalysisCommand> list = [] {
    std::vector<AnalysisCommand> all = {
        {"modes", "undamped natural frequencies and modes", {}, modes_of},
        {"roots", "damped roots", {}, roots_of},
        {"response",
         "amplitude- and phase-frequency characteristics",
         {"response", "limits", "limit_lines"},
         response_of},
        {"peaks", "exact resonance peaks", {"peaks", "response"}, peaks_of},
        {"static", "static displacements and forces", {"static"}, static_of},
    };
    for (const AnalysisRun& analysis : analysis_runs())
      all.push_back({analysis.name, analysis.about, {analysis.name}, [&analysis](const Case& variant) {
                       return own_request(analysis, variant);
                     }});
    all.push_back({"limit_lines",
                   "response curves compared with limit lines over frequency",
                   {"response", "limit_lines"},
                   limit_lines_of});
    all.push_back({"measurements",
                   "measured curves and mode shapes compared with computed ones",
                   {"response", "measurements"},
                   measurements_of});
    return all;
  }();
  return list;
}

const AnalysisCommand& analysis_command(const std::string& name) {
  const auto& list = analysis_commands();
  const auto found = std::ranges::find(list, name, &AnalysisCommand::name);
  if (found == list.end()) throw foundation::InvalidInput("no analysis is called \"" + name + "\"");
  return *found;
}

}  // namespace trivet::study
