// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/map_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "trivet/project/text/changes.h"
#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

/// First error that changes cause in addition to the known ones.
std::optional<foundation::Problem> first_new_error(Node model, const std::vector<Node>& changes,
                                                   const foundation::Problems& known, const ReadModel& read) {
  foundation::Problems found;
  for (const Node& change : changes) apply_changes(model, change, "", found);
  found.add(read(model));
  for (const foundation::Problem& problem : found.list()) {
    const bool old = std::any_of(known.list().begin(), known.list().end(), [&](const foundation::Problem& p) {
      return p.subject == problem.subject && p.rule == problem.rule;
    });
    if (problem.severity == foundation::Severity::error && !old) return problem;
  }
  return std::nullopt;
}

}  // namespace

Node without_questions(Node document) {
  for (const char* question : {"analyses", "limits", "limit_lines", "requirements", "cases"})
    if (const auto at = std::find(document.keys.begin(), document.keys.end(), question); at != document.keys.end()) {
      document.items.erase(document.items.begin() + (at - document.keys.begin()));
      document.keys.erase(at);
    }
  return document;
}

void check_map_numbers(const Node& document, const MapRequest& map, const ReadModel& read,
                       foundation::Problems& problems) {
  const Node model = without_questions(document);
  const auto changed = [](const MapAxis& axis, double value) {
    return change_of(path_keys(axis.parameter), value, axis.unit);
  };
  for (const auto& [key, axis, other] : {std::tuple{"x", &map.x, &map.y}, {"y", &map.y, &map.x}}) {
    const std::string subject = std::string("analyses.map.") + key;
    const auto reported = [&](const std::string& of) {
      return std::any_of(problems.list().begin(), problems.list().end(),
                         [&](const foundation::Problem& p) { return p.subject.starts_with("analyses.map." + of); });
    };
    if (path_keys(axis->parameter).empty() || reported(key + std::string(".parameter"))) continue;
    const bool has_range = !reported(key);
    std::vector<std::vector<Node>> designs;
    if (has_range)
      for (const double value : {axis->from, axis->to, axis->at(0.5)}) designs.push_back({changed(*axis, value)});
    designs.push_back({changed(*axis, 1.0)});
    if (has_range && !reported(key == std::string("x") ? "y" : "x"))
      for (const double a : {axis->from, axis->to})
        for (const double b : {other->from, other->to}) designs.push_back({changed(*axis, a), changed(*other, b)});
    std::optional<foundation::Problem> first;
    bool possible = false;
    for (std::size_t d = 0; d < designs.size() && !possible; ++d) {
      const auto problem = first_new_error(model, designs[d], problems, read);
      possible = !problem;
      if (!first) first = problem;
    }
    if (possible || (!has_range && first->finding != "unknown key")) continue;  // 1 may be outside an unreadable range
    problems
        .error(subject + ".parameter", "\"" + axis->parameter.substr(0, 80) + "\"",
               fmt::format("the model rejects this parameter: {}: {}; {}", first->subject, first->finding, first->rule),
               first->remedy)
        .origin = deepest(document, subject + ".parameter").origin;
  }
}

}  // namespace trivet::project
