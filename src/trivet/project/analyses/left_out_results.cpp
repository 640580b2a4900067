// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/drive.h"
#include "trivet/project/analyses/request_readers.h"

#include <algorithm>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/model/point_mass.h"

namespace trivet::project {
namespace {

/// Names of results by the path of the analysis that requests them.
std::vector<std::pair<std::string, std::vector<std::string>>> requested(const Analyses& request) {
  std::vector<std::pair<std::string, std::vector<std::string>>> all;
  if (request.response) all.emplace_back("analyses.response.of", request.response->selection.of);
  const bool of_response =
      request.peaks && request.response && request.peaks->selection.of == request.response->selection.of;
  if (request.peaks && !of_response) all.emplace_back("analyses.peaks.of", request.peaks->selection.of);
  if (request.static_of) all.emplace_back("analyses.static.of", *request.static_of);
  for (const auto& [name, analysis] : independent_analyses(request))
    all.emplace_back(table_path(name) + ".of", analysis.selection.of);
  if (request.map) {
    all.emplace_back("analyses.map.no_peak", request.map->no_peak);
    for (const AmplitudeLimit& limit : request.map->limits)
      all.emplace_back("analyses.map.limits", std::vector<std::string>{limit.name});
  }
  for (const Limit& limit : request.limits) all.emplace_back("limits", std::vector<std::string>{limit.name});
  for (const LimitLineRequest& line : request.limit_lines)
    all.emplace_back("limit_lines." + line.line.name, std::vector<std::string>{line.of});
  for (const auto& measurement : request.measurements)
    for (const MeasuredCurve& curve : measurement->curves)
      all.emplace_back("measurements." + measurement->name, std::vector<std::string>{curve.result});
  return all;
}

/// True if the word names a direction of this node that is left out.
bool names_left_out(const std::string& word, const model::Body& node) {
  for (std::size_t j = 0; j < 6; ++j)
    for (const char* kind : {".", ".relative."})
      if (node.left_out[j] && word == node.name + kind + model::coordinate_names[j]) return true;
  return false;
}

/// True if the word names a component of a relative motion in a direction that is left out at one of its nodes.
bool names_left_out(const std::string& word, const model::RelativeMotion& motion, const model::System& system) {
  for (int j = 0; j < 6; ++j)
    if (word == motion.name + "." + model::relative_components[j] && model::is_left_out(system.bodies(), motion, j))
      return true;
  return false;
}

}  // namespace

void refuse_left_out_results(const model::System& system, const Analyses& request, foundation::Problems& problems) {
  if (std::ranges::none_of(system.bodies(), [](const model::Body& b) { return model::turns_without_mass(b); })) return;
  for (const auto& [path, words] : requested(request))
    for (const std::string& word : words) {
      for (const model::RelativeMotion& motion : system.description().relative_motions)
        if (names_left_out(word, motion, system))
          problems.error(path, foundation::quoted(word),
                         "no element holds this direction at a node of the relative motion, so it is left out",
                         "remove it, or add an element that holds it");
      for (const model::Body& node : system.bodies())
        if (names_left_out(word, node))
          problems.error(path, foundation::quoted(word),
                         std::string("no element holds this direction of ") +
                             (node.is_node ? "node \"" : "point mass \"") + node.name + "\", so it is left out",
                         "remove it, or add an element that holds it");
    }
}

}  // namespace trivet::project
