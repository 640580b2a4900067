// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map_marks.h"

#include <algorithm>
#include <functional>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/pieces.h"
#include "trivet/design/design_evaluation.h"
#include "trivet/project/text/design_parameter.h"

namespace trivet::study {
namespace {

/// The number on an axis; a scale that is not written is 1.
std::optional<double> number_of(const Case& variant, const MapAxis& axis) {
  const std::vector<std::string> keys = path_keys(axis.parameter);
  const Node* node = behind(variant.document, keys);
  if (!node && (keys.back() == "scale" || keys.back() == "stiffening")) return 1.0;
  const auto written = node ? written_number(*node) : std::nullopt;
  return written ? in_unit(*written, axis.unit) : std::nullopt;
}

/// Why some work cannot be done; empty if it was.
std::string why_not(const std::function<void()>& work) {
  try {
    work();
  } catch (const foundation::NotComputable& reason) {
    return reason.what();
  } catch (const foundation::InvalidInput& reason) {
    return reason.what();
  }
  return "";
}

void judge(const Case& variant, const DesignEvaluation& evaluation, MapMark& mark) {
  mark.failure = why_not([&] { mark.judged = evaluation.judged(variant.system); });
  // What cannot be compared is not known to be a design of this map.
  static_cast<void>(why_not([&] { mark.of_this_model = mark.placed() && evaluation.is_at(variant.system, {*mark.x, *mark.y}); }));
}

/// Would the map of this case ask otherwise? Grids and lists of cases aside.
bool has_other_rules(const Case& variant, const MapRequest& request) {
  if (!variant.analyses.map) return false;
  MapRequest own = *variant.analyses.map;
  own.x.points = request.x.points;
  own.y.points = request.y.points;
  own.cases = request.cases;
  return !(own == request);
}

}  // namespace

std::vector<MapMark> map_marks(const Project& project, const MapRequest& request, const DesignEvaluation& evaluation, int threads,
                               const foundation::Progress& progress) {
  std::vector<MapMark> all;
  std::vector<const Case*> cases;
  for (const Case& c : project.cases) {
    const bool listed = request.cases && std::find(request.cases->begin(), request.cases->end(), c.name) != request.cases->end();
    MapMark mark{c.name, number_of(c, request.x), number_of(c, request.y), false, {}, ""};
    if (request.cases ? !listed : !mark.placed()) continue;
    mark.has_own_rules = has_other_rules(c, request);
    all.push_back(std::move(mark));
    cases.push_back(&c);
  }
  foundation::for_each_piece(all.size(), {1, threads, progress, "cases"}, [&](std::size_t k, std::size_t) { judge(*cases[k], evaluation, all[k]); });
  return all;
}

}  // namespace trivet::study
