// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/project_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "trivet/foundation/message_list.h"
#include "trivet/foundation/version.h"
#include "trivet/project/input_files.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/results/model/model_words.h"
#include "trivet/study/whole_study.h"

namespace trivet::results {
namespace {

using json::Json;

Json facts_json(const model::Element& element) {
  Json list = Json::array();
  for (const model::Fact& fact : element.facts) list.push_back({{"what", fact.what}, {"value", fact.value}});
  return list;
}

Json excitation_json(const model::Description& d, const model::Excitation& excitation) {
  const model::Action& action = excitation.action;
  const ExcitationNumbers numbers = excitation_numbers(excitation);
  Json result{{"name", excitation.name},
              {"type", numbers.type},
              {"at", json::list(action.at)},
              {"phase", json::list(numbers.phase)}};
  if (!action.body || numbers.linear_unit != "N") result["units"] = {numbers.linear_unit, numbers.angular_unit};
  result["on"] = action.body ? Json(d.bodies[*action.body].name) : Json(nullptr);
  result[action.body ? "force" : "translation"] = json::list(numbers.linear);
  result[action.body ? "moment" : "rotation"] = json::list(numbers.angular);
  return result;
}

Json coordinates_json(const std::array<bool, 6>& named) {
  Json names = Json::array();
  for (std::size_t j = 0; j < 6; ++j)
    if (named[j]) names.push_back(model::coordinate_names[j]);
  return names;
}

Json names_json(const std::vector<model::Element>& elements, const model::Section& section) {
  Json names = Json::array();
  for (const std::size_t e : section.elements) names.push_back(elements[e].name);
  return names;
}

/// Adds relative motions, sections and clearances, if there are any.
void add_observations(const model::Description& d, Json& result) {
  for (const model::RelativeMotion& motion : d.relative_motions)
    result["relative"].push_back(
        {{"name", motion.name}, {"of", motion.of.name}, {"to", motion.to.name}, {"axes", json::rows(motion.axes)}});
  for (const model::Section& section : d.sections)
    result["sections"].push_back({{"name", section.name},
                                  {"elements", names_json(d.elements, section)},
                                  {"at", json::list(section.at)},
                                  {"axes", json::rows(section.axes)}});
  for (const model::Clearance& clearance : d.clearances)
    result["clearances"].push_back({{"name", clearance.name},
                                    {"between", {clearance.of.name, clearance.to.name}},
                                    {"direction", json::list(clearance.direction)},
                                    {"gap", clearance.gap}});
}

Json model_of(const project::Case& variant) {
  const model::Description& d = variant.system.description();
  Json result{{"bodies", Json::array()},
              {"elements", Json::array()},
              {"excitations", Json::array()},
              {"gravity", d.gravity ? json::list(*d.gravity) : Json(nullptr)},
              {"damping", damping_words(d.damping)}};
  if (!d.second_order) result["second_order"] = false;
  for (const auto& body : d.bodies) {
    if (body.is_node) continue;
    Json points = Json::object();
    for (const auto& point : body.points) points[point.name] = json::list(point.at);
    result["bodies"].push_back({{"name", body.name},
                                {"mass", body.mass.mass},
                                {"center_of_mass", json::list(body.mass.centre)},
                                {"inertia_about_pole", json::rows(spatial::inertia_about_pole(body.mass))},
                                {"principal_moments", json::list(spatial::principal_inertia(body.mass).moments)},
                                {"position", json::list(body.pose.position)},
                                {"rotation", json::rows(body.pose.rotation)},
                                {"points", std::move(points)},
                                {"free", coordinates_json(body.free)}});
  }
  for (const auto& node : d.bodies)
    if (node.is_node)
      result["nodes"].push_back({{"name", node.name},
                                 {"position", json::list(node.pose.position)},
                                 {"rotation", json::rows(node.pose.rotation)},
                                 {"free", coordinates_json(node.free)},
                                 {"left_out", coordinates_json(node.left_out)}});
  for (const auto& element : d.elements)
    result["elements"].push_back({{"name", element.name},
                                  {"type", element.type},
                                  {"scale", element.law.scale},
                                  {"damping", damping_words(element.law.damping)},
                                  {"facts", facts_json(element)},
                                  {"preload", element.law.preload ? json::list(*element.law.preload) : Json(nullptr)},
                                  {"n", json::end(variant, element.n)},
                                  {"k", json::end(variant, element.k)},
                                  {"stiffness", json::rows(elements::stiffness(element.law))},
                                  {"viscous_damping", json::rows(elements::viscous_damping(element.law))}});
  for (const model::Foundation& foundation : d.foundations)
    result["foundations"].push_back({{"name", foundation.name},
                                     {"mass", json::rows(foundation.mass)},
                                     {"damping", json::rows(foundation.damping)},
                                     {"stiffness", json::rows(foundation.stiffness)}});
  for (const model::Excitation& excitation : d.excitations)
    result["excitations"].push_back(excitation_json(d, excitation));
  for (const auto& force : d.constant_forces)
    result["excitations"].push_back({{"name", force.name},
                                     {"type", "constant"},
                                     {"on", d.bodies[force.body].name},
                                     {"at", json::list(force.at)},
                                     {"force", json::list(force.wrench.force)},
                                     {"moment", json::list(force.wrench.moment)}});
  add_observations(d, result);
  return result;
}

Json case_json(const project::Case& variant, const study::CaseResults& results) {
  Json checks = Json::array();
  for (const study::CheckLine& line : study::check_lines(variant))
    checks.push_back({{"subject", line.subject}, {"what", line.what}, {"value", line.value}, {"passed", line.passed}});
  Json limits = Json::array();
  for (const study::LimitResult& limit : results.limits)
    limits.push_back({{"name", limit.name},
                      {"unit", limit.unit},
                      {"limit", limit.limit},
                      {"in_band", json::number(limit.in_band)},
                      {"in_band_at", limit.in_band_at},
                      {"anywhere", json::number(limit.anywhere)},
                      {"kept", limit.met}});
  Json result{{"name", results.case_name},
              {"changes", results.changes},
              {"warnings", json::warnings(results.warnings)},
              {"free_motions", results.free_motions},
              {"not_computed", results.failures},
              {"model", model_of(variant)},
              {"checks", std::move(checks)},
              {"limits", std::move(limits)}};
  if (!results.notes.empty()) result["notes"] = results.notes;
  if (results.verdict) result["verdict"] = json::verdict(*results.verdict);
  for (const ResultWriter& writer : result_writers()) {
    if (!writer.is_there(variant, results)) continue;
    const std::string name = writer.name;
    if (name == "response") result["band"] = {results.response->band.from, results.response->band.to};
    result[name] = written_json(writer, variant, results);
  }
  return result;
}

/// What the page draws of a case: limits, modes, peaks, and a model of its curves.
Json drawn_case(const project::Case& variant, const study::CaseResults& results) {
  Json result{
      {"name", results.case_name}, {"limits", Json::array()}, {"modes", Json::array()}, {"peaks", Json::array()}};
  for (const study::LimitResult& limit : results.limits)
    result["limits"].push_back({{"name", limit.name}, {"unit", limit.unit}, {"limit", limit.limit}});
  if (variant.analyses.modes)
    for (const modal::Mode& mode : results.modes.list)
      if (mode.angular_frequency.value_or(0) > 0)
        result["modes"].push_back(
            {{"number", mode.number}, {"angular_frequency", *mode.angular_frequency}, {"name", mode.name}});
  if (results.peaks) {
    const response::Peaks& found = results.peaks->peaks;
    for (const response::Peak& peak : found.list)
      result["peaks"].push_back({{"name", found.curves[peak.curve].name},
                                 {"unit", found.curves[peak.curve].unit},
                                 {"angular_frequency", peak.angular_frequency},
                                 {"amplitude", json::number(peak.amplitude)},
                                 {"ratio_to_static", json::optional(peak.ratio_to_static)},
                                 {"nearest_mode", json::optional(peak.nearest_mode)},
                                 {"unbounded", std::isinf(peak.amplitude)}});
    for (const response::CurveSummary& curve : found.curves)
      if (curve.vanishes) result["vanishing"].push_back({{"name", curve.name}, {"unit", curve.unit}});
  }
  if (results.response) result["response"] = json::drawn_response(results);
  return result;
}

}  // namespace

namespace {

/// The project file, and the files that it names.
Json input_json(const project::Project& project) {
  const std::vector<project::InputFile> files = project::input_files(project);
  Json named = Json::array();
  for (const project::InputFile& file : files) named.push_back({{"file", file.name}, {"sha256", file.sha256}});
  return {{"file", std::filesystem::path(project.source).filename().string()},
          {"sha256", project::input_hash(project, files)},
          {"files", named}};
}

Json head_of_results(const project::Project& project) {
  return Json{{"format", "trivet-results"},
              {"format_version", 1},
              {"program", {{"name", "trivet"}, {"version", foundation::version()}}},
              {"input", input_json(project)},
              {"title", project.title},
              {"cases", Json::array()}};
}

}  // namespace

std::string case_results_json(const project::Project& project, const project::Case& variant,
                              const study::CaseResults& results) {
  Json result = head_of_results(project);
  result["cases"].push_back(case_json(variant, results));
  return json::text(result) + "\n";
}

std::string results_json(const project::Project& project, const std::vector<study::CaseResults>& results) {
  Json result = head_of_results(project);
  for (std::size_t i = 0; i < results.size(); ++i) result["cases"].push_back(case_json(project.cases[i], results[i]));
  if (const study::Envelope envelope = study::envelope_of(results); !envelope.rows.empty())
    result["envelope"] = json::envelope(envelope);
  return json::text(result) + "\n";
}

std::string page_json(const project::Project& project, const std::vector<study::CaseResults>& results) {
  Json result{{"cases", Json::array()}};
  for (std::size_t i = 0; i < results.size(); ++i) result["cases"].push_back(drawn_case(project.cases[i], results[i]));
  return json::text(result) + "\n";
}

std::string model_json(const project::Case& variant) { return json::text(model_of(variant), 1) + "\n"; }

std::string problems_json(const foundation::Problems& problems, const std::vector<std::string>& free_motions,
                          const std::vector<study::CaseCheck>& cases) {
  Json list = Json::array();
  const foundation::Problems first = foundation::listed(problems);
  for (const auto& p : first.list())
    list.push_back({{"severity", p.severity == foundation::Severity::error ? "error" : "warning"},
                    {"file", p.origin.source},
                    {"line", p.origin.line},
                    {"subject", p.subject},
                    {"finding", p.finding},
                    {"rule", p.rule},
                    {"remedy", p.remedy},
                    {"message", foundation::message(p)}});
  Json result{{"ok", !problems.has_errors()},
              {"problems", std::move(list)},
              {"not_listed", problems.list().size() - first.list().size()},
              {"free_motions", free_motions},
              {"warnings", json::warnings(problems)}};
  for (const study::CaseCheck& one : cases)
    for (const study::MountAtRest& mount : one.mounts)
      result["mounts"].push_back(
          {{"case", one.case_name},
           {"element", mount.name},
           {"compression", mount.compression},
           {"across", mount.across},
           {"deflection", mount.deflection},
           {"utilisation", mount.utilisation ? json::number(*mount.utilisation) : Json(nullptr)}});
  for (const study::CaseCheck& one : cases) {
    if (!one.deep) continue;
    const response::DeepCheck& check = *one.deep;
    result["deep"].push_back({{"case", one.case_name},
                              {"verdict", check.verdict()},
                              {"frequencies", check.frequencies},
                              {"worst_difference", json::number(check.worst_difference)},
                              {"allowed", json::number(check.allowed)},
                              {"at", check.at_angular_frequency}});
  }
  return json::text(result, 1) + "\n";
}

}  // namespace trivet::results
