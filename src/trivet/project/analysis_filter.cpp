// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analysis_filter.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <variant>

#include "trivet/model/operating_excitation.h"
#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/analyses/isolation_reader.h"
#include "trivet/project/analyses/request_readers.h"
#include "trivet/project/text/unsupported_keys.h"

namespace trivet::project {
namespace {

/// Functions that remove the analyses that are fields of `Analyses`.
const std::vector<std::pair<std::string, std::function<void(Analyses&)>>>& removals() {
  static const std::vector<std::pair<std::string, std::function<void(Analyses&)>>> list = {
      {"modes", [](Analyses& a) { a.modes = false; }},
      {"roots", [](Analyses& a) { a.roots = false; }},
      {"response", [](Analyses& a) { a.response.reset(); }},
      {"peaks", [](Analyses& a) { a.peaks.reset(); }},
      {"static", [](Analyses& a) { a.static_of.reset(), a.load_sharing = false; }},
      {"map", [](Analyses& a) { a.map.reset(); }},
      {"limits", [](Analyses& a) { a.limits.clear(); }},
      {"limit_lines", [](Analyses& a) { a.limit_lines.clear(); }},
      {"measurements", [](Analyses& a) { a.measurements.clear(); }},
      {"requirements", [](Analyses& a) { a.requirements.reset(); }},
      {"parameters", [](Analyses& a) { a.parameters.clear(); }},
      {"optimize", [](Analyses& a) { a.optimize.reset(); }},
      {"tolerances", [](Analyses& a) { a.tolerances.clear(); }},
      {"sample", [](Analyses& a) { a.sample.reset(); }},
      {"box", [](Analyses& a) { a.box.reset(); }},
  };
  return list;
}

/// Analysis of a subject: "static" for "analyses.static.of", "limits" for "limits.\"body.x\"", "analyses" for the table
/// itself; empty for a part of the model.
std::string analysis_of(const std::string& subject) {
  std::string first = subject.substr(0, subject.find('.'));
  for (const char* table : {"limits", "limit_lines", "measurements", "requirements", "parameters", "tolerances"})
    if (first == table) return first;
  for (const AnalysisReader& reader : analysis_readers())
    if (reader.at_top && first == reader.name) return first;
  if (first != "analyses") return "";
  if (subject == first) return first;
  const std::size_t from = first.size() + 1;
  return subject.substr(from, subject.find('.', from) - from);
}

/// Names of the excitations that the analyses use, and whether any analysis takes excitations.
struct UsedExcitations {
  std::set<std::string> names;
  bool any_analysis = false;
};

class UsedExcitationCollector {
 public:
  UsedExcitationCollector(const Case& variant, UsedExcitations& used) : variant_(variant), used_(used) {}

  void collect() {
    const Analyses& a = variant_.analyses;
    const auto add_request = [&](const auto& request, const auto& drives) {
      if (request) add_excitations(request->selection.excitations, drives);
    };
    add_request(a.response, harmonic);
    add_request(a.peaks, harmonic);
    for (const auto& measurement : a.measurements)
      if (!measurement->excitation.empty()) used_.names.insert(measurement->excitation);
    for (const auto& [name, analysis] : independent_analyses(a))
      if (name != "operation") add_analysis(analysis, drive_of(name));
    if (a.operation) add_excitations_of_operation(a.operation->selection.excitations);
    if (a.requirements) add_requirements(*a.requirements);
    if (!variant_.system.description().clearances.empty()) add_excitations_of_clearances();
    if (a.static_of) add_constant_forces();
    if (a.map) add_excitations(a.map->excitations, harmonic);
    if (a.optimize && !a.optimize->minimize.empty()) add_excitations({}, harmonic);
  }

 private:
  /// Without a selection those that run with the machine; no motion of the ground does.
  void add_excitations_of_operation(const std::vector<std::string>& selected) {
    used_.any_analysis = true;
    used_.names.insert(selected.begin(), selected.end());
    if (!selected.empty()) return;
    for (const model::Excitation& excitation : variant_.system.description().excitations)
      if (model::runs_with_machine(excitation)) used_.names.insert(excitation.name);
  }

  void add_requirements(const Requirements& required) {
    bool common = !required.no_peak.empty();
    for (const AmplitudeLimit& limit : required.limits) {
      if (limit.speed) add_excitations(limit.excitations.value_or(std::vector<std::string>()), by_orders);
      else if (limit.excitations) add_excitations(*limit.excitations, harmonic);
      else common = true;
    }
    if (common) add_excitations(required.excitations, harmonic);
    for (const Isolation& isolation : required.isolation)
      for (const std::string& force : isolated_forces(isolation, variant_.system)) used_.names.insert(force);
    if (!required.rms.empty()) add_excitations({}, random);
    if (!required.largest.empty()) add_excitations({}, in_time);
    if (!required.statics.empty() || required.mount_load) add_constant_forces();
  }

  /// Those of the harmonic amplitudes and of the position of rest; a transient is an analysis of its own.
  void add_excitations_of_clearances() {
    const Analyses& a = variant_.analyses;
    if (a.requirements && !a.requirements->excitations.empty()) add_excitations(a.requirements->excitations, harmonic);
    else add_excitations(a.response ? a.response->selection.excitations : std::vector<std::string>(), harmonic);
    add_constant_forces();
  }

  void add_constant_forces() {
    for (const model::ConstantForce& force : variant_.system.description().constant_forces)
      used_.names.insert(force.name);
  }

  void add_analysis(const Analysis& analysis, Drive drive) {
    const std::vector<std::string>& selected = analysis.selection.excitations;
    switch (drive) {
      case Drive::none:
        used_.names.insert(selected.begin(), selected.end());
        break;
      case Drive::harmonic:
        add_excitations(selected, harmonic);
        break;
      case Drive::random:
        add_excitations(selected, random);
        break;
      case Drive::time:
        add_excitations(selected, in_time);
        break;
      case Drive::orders:
        add_excitations(selected, by_orders);
        break;
      case Drive::harmonic_or_orders:
        add_excitations(selected, [](const model::Course& course) { return harmonic(course) || by_orders(course); });
        break;
    }
  }

  static bool harmonic(const model::Course& course) { return std::holds_alternative<model::Harmonic>(course); }
  static bool random(const model::Course& course) { return std::holds_alternative<model::Random>(course); }
  static bool in_time(const model::Course& course) { return std::holds_alternative<model::History>(course); }
  static bool by_orders(const model::Course& course) {
    const auto* rotating = std::get_if<model::Harmonic>(&course);
    return std::holds_alternative<model::Orders>(course) || (rotating && rotating->power_of_frequency == 2);
  }

  template <typename Drives>
  void add_excitations(const std::vector<std::string>& selected, const Drives& drives) {
    used_.any_analysis = true;
    used_.names.insert(selected.begin(), selected.end());
    if (!selected.empty()) return;
    for (const model::Excitation& excitation : variant_.system.description().excitations)
      if (drives(excitation.course)) used_.names.insert(excitation.name);
  }

  const Case& variant_;
  UsedExcitations& used_;
};

}  // namespace

bool is_requested(const std::string& analysis, const AnalysisFilter& filter, const std::string& of_case) {
  if (analysis.empty()) return true;  // the model
  if (filter.of_case && *filter.of_case != of_case) return false;
  if (!filter.requested) return true;
  const std::vector<std::string>& requested = *filter.requested;
  if (std::ranges::find(requested, analysis) != requested.end()) return true;
  const bool known = analysis == "clearances" ||
      std::ranges::any_of(removals(), [&](const auto& one) { return one.first == analysis; }) ||
      std::ranges::any_of(analysis_readers(), [&](const AnalysisReader& one) { return one.name == analysis; });
  // A misspelt name may be any analysis, so it concerns each of them.
  return !known && !is_unsupported_analysis(analysis) && !requested.empty();
}

bool is_only_setting(const std::string& analysis, const AnalysisFilter& filter, const std::string& of_case) {
  return filter.requested && filter.command != analysis && is_requested(analysis, filter, of_case);
}

Analyses counted_part(const AnalysisFilter& filter, const Analyses& analyses) {
  Analyses counted;
  if (filter.command == "modes") {
    counted.modes = true;
    counted.lowest_modes = filter.lowest_modes > 0 ? filter.lowest_modes : analyses.lowest_modes;
  } else if (filter.command == "response") {
    counted.response = analyses.response;
    counted.limits = analyses.limits;
    counted.limit_lines = analyses.limit_lines;
    counted.lowest_modes = modes_beside_a_response;
  } else {
    counted = analyses;
    if (filter.requested) counted.lowest_modes = 0;  // this command may need all modes
  }
  return counted;
}

void check_analyses(const model::System& system, const Analyses& request, const AnalysisFilter& filter,
                    const std::string& of_case, foundation::Problems& problems) {
  const auto computed = [&](const std::string& analysis) { return !is_only_setting(analysis, filter, of_case); };
  check_analyses(system, request, computed, problems);
  check_requirements(system, request, problems);
}

std::vector<std::pair<std::string, assembly::Band>> requested_bands(const Analyses& request) {
  std::vector<std::pair<std::string, assembly::Band>> bands;
  for (const AnalysisReader& reader : analysis_readers())
    if (const auto band = reader.band(request)) bands.emplace_back(reader.name, *band);
  return bands;
}

foundation::Problems without_unrequested(const foundation::Problems& found, const AnalysisFilter& filter,
                                         const std::string& of_case, Analyses& analyses) {
  if (!filter.requested && !filter.of_case) return found;
  std::set<std::string> broken;
  for (const foundation::Problem& problem : found.list()) {
    const std::string analysis = analysis_of(problem.subject);
    if (problem.severity == foundation::Severity::error && !is_requested(analysis, filter, of_case))
      broken.insert(analysis);
  }
  foundation::Problems kept;
  for (const foundation::Problem& problem : found.list())
    if (!broken.contains(analysis_of(problem.subject))) kept.add(problem);
  for (const auto& [name, remove] : removals())
    if (broken.contains(name)) remove(analyses);
  for (const AnalysisReader& reader : analysis_readers())
    if (broken.contains(reader.name)) reader.remove(analyses);
  return kept;
}

bool has_broken_curves(const Case& variant) {
  const Node* request = variant.document.find("analyses");
  return request &&
      ((request->find("peaks") && !variant.analyses.peaks) ||
       (request->find("response") && !variant.analyses.response));
}

foundation::Problems unused_parts(const std::vector<Case>& cases) {
  foundation::Problems found;
  UsedExcitations used;
  for (const Case& variant : cases) UsedExcitationCollector(variant, used).collect();
  if (!used.any_analysis || cases.empty()) return found;
  const Case& base = cases.front();
  std::vector<std::string> names;
  for (const model::Excitation& excitation : base.system.description().excitations) names.push_back(excitation.name);
  for (const model::ConstantForce& force : base.system.description().constant_forces) names.push_back(force.name);
  for (const std::string& name : names)
    if (!used.names.contains(name))
      found
          .warning("excitations." + name, "no analysis of this file uses it",
                   "an excitation acts only in requested analyses that select it",
                   "add the analysis, select it, or remove it")
          .origin = deepest(base.document, "excitations." + name).origin;
  return found;
}

}  // namespace trivet::project
