// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/map_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "trivet/project/model_number.h"
#include "trivet/project/parameter_conflicts.h"
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

bool has_problem_at(const foundation::Problems& problems, const std::string& path) {
  return std::any_of(problems.list().begin(), problems.list().end(),
                     [&](const foundation::Problem& p) { return p.subject.starts_with(path); });
}

/// Reports an axis if the model rejects each of these designs; the first reason is the finding.
void refuse_if_all_fail(const Node& document, const std::vector<std::vector<Node>>& designs, const DesignAxis& axis,
                        const std::string& subject, bool has_range, const ReadModel& read,
                        foundation::Problems& problems) {
  const Node model = without_questions(document);
  std::optional<foundation::Problem> first;
  for (const std::vector<Node>& design : designs) {
    const auto problem = first_new_error(model, design, problems, read);
    if (!problem) return;
    if (!first) first = problem;
  }
  if (!has_range && first->finding != "unknown key") return;  // 1 may be outside an unreadable range
  problems
      .error(subject, "\"" + axis.parameter.substr(0, 80) + "\"",
             fmt::format("the model rejects this parameter: {}: {}; {}", first->subject, first->finding, first->rule),
             first->remedy)
      .origin = deepest(document, subject).origin;
}

Node changed(const DesignAxis& axis, double value) { return ModelNumber(axis).change(value); }

}  // namespace

Node without_questions(Node document) {
  for (const char* question :
       {"analyses", "limits", "limit_lines", "measurements", "requirements", "parameters", "cases"})
    if (const auto at = std::find(document.keys.begin(), document.keys.end(), question); at != document.keys.end()) {
      document.items.erase(document.items.begin() + (at - document.keys.begin()));
      document.keys.erase(at);
    }
  return document;
}

void check_map_numbers(const Node& document, const MapRequest& map, const ReadModel& read,
                       foundation::Problems& problems) {
  if (!map.pairs.empty()) return;  // see check_parameters
  for (const auto& [key, axis, other] : {std::tuple{"x", &map.x, &map.y}, {"y", &map.y, &map.x}}) {
    const std::string subject = std::string("analyses.map.") + key;
    if (path_keys(axis->parameter).empty() || has_problem_at(problems, subject + ".parameter")) continue;
    const bool has_range = !has_problem_at(problems, subject);
    std::vector<std::vector<Node>> designs;
    if (has_range)
      for (const double value : {axis->from, axis->to, axis->at(0.5)}) designs.push_back({changed(*axis, value)});
    designs.push_back({changed(*axis, 1.0)});
    if (has_range && !has_problem_at(problems, std::string("analyses.map.") + (key == std::string("x") ? "y" : "x")))
      for (const double a : {axis->from, axis->to})
        for (const double b : {other->from, other->to}) designs.push_back({changed(*axis, a), changed(*other, b)});
    refuse_if_all_fail(document, designs, *axis, subject + ".parameter", has_range, read, problems);
  }
}

void check_parameters(const Node& document, const std::vector<DesignAxis>& parameters, const ReadModel& read,
                      foundation::Problems& problems) {
  refuse_derived_numbers(document, parameters, problems);
  constexpr int tried = 8;  // parts of the range: a model may be valid in a part of it only
  for (const DesignAxis& axis : parameters) {
    const std::string subject = "parameters." + axis.name;
    const bool has_paths = !axis.places.empty() &&
        std::none_of(axis.places.begin(), axis.places.end(),
                     [](const ParameterPlace& place) { return path_keys(place.path).empty(); });
    if (!has_paths || has_problem_at(problems, subject)) continue;
    std::vector<std::vector<Node>> designs;
    for (int i = 0; i <= tried; ++i) designs.push_back({changed(axis, axis.at(static_cast<double>(i) / tried))});
    refuse_if_all_fail(document, designs, axis, subject + ".path", true, read, problems);
  }
}

}  // namespace trivet::project
