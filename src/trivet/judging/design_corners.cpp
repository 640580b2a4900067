// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/design_corners.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "trivet/foundation/plain_text.h"
#include "trivet/judging/checked_case.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/changes.h"
#include "trivet/project/text/model_path.h"

namespace trivet::judging {
namespace {

/// Reads a model without its analyses and returns its problems.
using ReadModel = std::function<foundation::Problems(const project::Node& model)>;

/// First error that changes cause in addition to the known ones.
std::optional<foundation::Problem> first_new_error(project::Node model, const std::vector<project::Node>& changes,
                                                   const foundation::Problems& known, const ReadModel& read) {
  foundation::Problems found;
  for (const project::Node& change : changes) project::apply_changes(model, change, "", found);
  found.add(read(model));
  for (const foundation::Problem& problem : found.list()) {
    const bool old = std::ranges::any_of(known.list(), [&](const foundation::Problem& p) {
      return p.subject == problem.subject && p.rule == problem.rule;
    });
    if (problem.severity == foundation::Severity::error && !old) return problem;
  }
  return std::nullopt;
}

bool has_problem_at(const foundation::Problems& problems, const std::string& path) {
  return std::ranges::any_of(problems.list(),
                             [&](const foundation::Problem& p) { return p.subject.starts_with(path); });
}

/// Reports an axis if the model rejects each of these designs; the first reason is the finding.
void refuse_if_all_fail(const project::Node& document, const std::vector<std::vector<project::Node>>& designs,
                        const project::DesignAxis& axis, const std::string& subject, bool has_range,
                        const ReadModel& read, foundation::Problems& problems) {
  const project::Node model = project::without_analyses(document);
  std::optional<foundation::Problem> first;
  for (const std::vector<project::Node>& design : designs) {
    const auto problem = first_new_error(model, design, problems, read);
    if (!problem) return;
    if (!first) first = problem;
  }
  if (!has_range && first->finding != "unknown key") return;  // 1 may be outside an unreadable range
  problems
      .error(subject, "\"" + axis.parameter.substr(0, 80) + "\"",
             fmt::format("the model rejects this parameter: {}: {}; {}", first->subject, first->finding, first->rule),
             first->remedy)
      .origin = project::deepest(document, subject).origin;
}

project::Node changed(const project::DesignAxis& axis, double value) {
  return project::ModelNumber(axis).change(value);
}

/// The numbers of a map: at the ends and the middle of each range, at 1, and together.
void check_map_numbers(const project::Node& document, const project::MapRequest& map, const ReadModel& read,
                       foundation::Problems& problems) {
  if (!map.pairs.empty()) return;  // see check_parameters
  for (const auto& [key, axis, other] : {std::tuple{"x", &map.x, &map.y}, {"y", &map.y, &map.x}}) {
    const std::string subject = std::string("analyses.map.") + key;
    if (project::path_keys(axis->parameter).empty() || has_problem_at(problems, subject + ".parameter")) continue;
    const bool has_range = !has_problem_at(problems, subject);
    std::vector<std::vector<project::Node>> designs;
    if (has_range)
      for (const double value : {axis->from, axis->to, axis->at(0.5)}) designs.push_back({changed(*axis, value)});
    designs.push_back({changed(*axis, 1.0)});
    if (has_range && !has_problem_at(problems, std::string("analyses.map.") + (key == std::string("x") ? "y" : "x")))
      for (const double a : {axis->from, axis->to})
        for (const double b : {other->from, other->to}) designs.push_back({changed(*axis, a), changed(*other, b)});
    refuse_if_all_fail(document, designs, *axis, subject + ".parameter", has_range, read, problems);
  }
}

/// The number of the type from which a number of an element is derived: elements.E.scale → element_types.T.scale.
std::optional<std::vector<std::string>> number_of_type(const project::Node& document, std::vector<std::string> keys) {
  if (keys.size() < 3 || keys.front() != "elements") return std::nullopt;
  const project::Node* type = project::node_at(document, {keys[0], keys[1], "type"});
  if (!type || type->kind != project::Node::Kind::text) return std::nullopt;
  keys[0] = "element_types";
  keys[1] = type->text;
  return keys;
}

/// Reports a parameter that moves a number of an element whose type has the same number, if a parameter moves that too.
/// @param document  as written, so that elements name their types
void refuse_derived_numbers(const project::Node& document, const std::vector<project::DesignAxis>& parameters,
                            foundation::Problems& problems) {
  for (const project::DesignAxis& parameter : parameters)
    for (const project::ParameterPlace& place : parameter.places) {
      const auto source = number_of_type(document, project::path_keys(place.path));
      if (!source) continue;
      for (const project::DesignAxis& other : parameters) {
        const auto same = std::ranges::find_if(
            other.places, [&](const project::ParameterPlace& one) { return project::path_keys(one.path) == *source; });
        if (same == other.places.end()) continue;
        const std::string subject = "parameters." + parameter.name + ".path";
        problems
            .error(subject, foundation::quoted(place.path),
                   "this number is derived from " + foundation::quoted(same->path) + ", which the parameter " +
                       foundation::quoted(other.name) + " moves",
                   "move the number of the type, or those of its elements")
            .origin = project::deepest(document, subject).origin;
      }
    }
}

/// Those of [parameters.NAME], each alone.
void check_parameters(const project::Node& document, const std::vector<project::DesignAxis>& parameters,
                      const ReadModel& read, foundation::Problems& problems) {
  refuse_derived_numbers(document, parameters, problems);
  constexpr int tried = 8;  // parts of the range: a model may be valid in a part of it only
  for (const project::DesignAxis& axis : parameters) {
    const std::string subject = "parameters." + axis.name;
    const bool has_paths = !axis.places.empty() &&
        std::ranges::none_of(
            axis.places, [](const project::ParameterPlace& place) { return project::path_keys(place.path).empty(); });
    if (!has_paths || has_problem_at(problems, subject)) continue;
    std::vector<std::vector<project::Node>> designs;
    for (int i = 0; i <= tried; ++i) designs.push_back({changed(axis, axis.at(static_cast<double>(i) / tried))});
    refuse_if_all_fail(document, designs, axis, subject + ".path", true, read, problems);
  }
}

}  // namespace

void check_corners(const project::ReadCase& read, bool of_map, bool of_parameters,
                   const project::AnalysisFilter& filter, foundation::Problems& problems) {
  std::optional<project::KnownModel> known;
  if (read.system) known.emplace(read.document, read.system->description());
  const auto read_model = [&](const project::Node& model) {
    foundation::Problems found;
    auto design = project::read_case(model, read.name, found, known ? &*known : nullptr);
    if (design) static_cast<void>(checked_case(std::move(*design), filter, nullptr, found));
    return found;
  };
  if (of_map) check_map_numbers(read.written, *read.analyses.map, read_model, problems);
  if (of_parameters) check_parameters(read.written, read.analyses.parameters, read_model, problems);
}

}  // namespace trivet::judging
