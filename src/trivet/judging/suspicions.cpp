// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/suspicions.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/judging/acceptances.h"
#include "trivet/plausibility/inertia_slips.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/analysis_filter.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::judging {
namespace {

const project::Node* find(const project::Node& document, const std::string& group, const std::string& name) {
  const project::Node* parts = document.find(group);
  return parts ? parts->find(name) : nullptr;
}

bool is_about_pole(const project::Node& document, const std::string& body) {
  const project::Node* table = find(document, "bodies", body);
  const project::Node* inertia = table ? table->find("inertia") : nullptr;
  const project::Node* about = inertia ? inertia->find("about") : nullptr;
  return about && about->text == "pole";
}

void add_bodies(const project::Case& variant, plausibility::Stated& stated) {
  for (const model::Body& body : variant.system.bodies()) {
    const project::Node* table = find(variant.document, "bodies", body.name);
    stated.inertia_about_pole.push_back(is_about_pole(variant.document, body.name));
    stated.from_solids.push_back(table && table->find("solids"));
  }
}

/// Oscillating mass (pistons and rods) of an engine.
void add_engine(const project::Node& table, const model::Excitation& excitation, plausibility::Stated& stated) {
  const project::Node* engine = table.find("engine");
  if (!engine || engine->kind != project::Node::Kind::table) return;
  foundation::Problems ignored;
  project::TableReader reader(*engine, "excitations." + excitation.name + ".engine", ignored);
  const auto mass = reader.number("oscillating_mass", project::Quantity::mass);
  const auto cylinders = reader.number("cylinders", project::Quantity::pure);
  if (mass && cylinders)
    stated.engines.push_back(
        {"excitations." + excitation.name + ".engine.oscillating_mass", *excitation.action.body, *mass, *cylinders});
}

void add_rotors(const project::Case& variant, plausibility::Stated& stated) {
  for (const model::Excitation& excitation : variant.system.description().excitations) {
    const project::Node* table = find(variant.document, "excitations", excitation.name);
    if (!table || !excitation.action.body) continue;
    const project::Node* type = table->find("type");
    add_engine(*table, excitation, stated);
    if (!type || type->text != "unbalance") continue;
    foundation::Problems ignored;
    project::TableReader reader(*table, "excitations." + excitation.name, ignored);
    const auto speed = reader.number("service_speed", project::Quantity::angular_frequency);
    stated.rotors.push_back({excitation.name, *excitation.action.body,
                             reader.number("rotor_mass", project::Quantity::mass),
                             reader.number("mass_eccentricity", project::Quantity::mass_length),
                             reader.number("grade", project::Quantity::pure), speed});
    if (speed && table->find("service_speed")->kind != project::Node::Kind::text)
      stated.speeds.push_back({"excitations." + excitation.name + ".service_speed", *speed});
  }
}

/// True for "frame.z", false for "frame.rz" and "mount.force.z".
bool is_translation(const std::string& name) {
  const bool of_force = name.find(".force.") != std::string::npos || name.find(".moment.") != std::string::npos;
  return !of_force && (name.ends_with(".x") || name.ends_with(".y") || name.ends_with(".z"));
}

/// @param table  of the limit: "limits"
void add_limit(const std::string& table, const project::AmplitudeLimit& limit, plausibility::Stated& stated) {
  if (!is_translation(limit.name) || limit.quantity == assembly::MotionQuantity::acceleration) return;
  plausibility::AllowedMotion allowed{limit.name.substr(0, limit.name.find('.')), table + "." + limit.name, limit.name,
                                      limit.amplitude, limit.quantity == assembly::MotionQuantity::velocity};
  if (limit.level) {
    allowed.as_written = project::level_factor(*limit.level);
    allowed.level_ending = std::string(" ") + project::level_ending(*limit.level);
  }
  stated.allowed_motions.push_back(std::move(allowed));
}

/// A range of two numbers of which one that is not 0 has no unit.
bool is_bare_range(const project::Node& range) {
  return range.items.size() == 2 && std::ranges::any_of(range.items, [](const project::Node& end) {
           return end.kind != project::Node::Kind::text && end.number != 0;
         });
}

/// Ranges of [requirements] without units. With units they are meant: an operating range without a resonance is good.
void add_windows_of_requirements(const project::Case& variant, plausibility::Stated& stated) {
  const project::Node* table = variant.document.find("requirements");
  if (!table || !variant.analyses.requirements) return;
  const project::Node* band = table->find("band");
  if (const auto& read = variant.analyses.requirements->band; band && read && is_bare_range(*band))
    stated.windows.push_back({"requirements.band", read->from, read->to});
  const project::Node* natural = table->find("natural_frequencies");
  const project::Node* avoid = natural ? natural->find("avoid") : nullptr;
  if (!avoid) return;
  for (const project::Node& window : avoid->items)
    if (is_bare_range(window) && window.items[0].kind != project::Node::Kind::text &&
        window.items[1].kind != project::Node::Kind::text)
      stated.windows.push_back({.subject = "requirements.natural_frequencies.avoid",
                                .from = window.items[0].number,
                                .to = window.items[1].number,
                                .avoided = true});
}

/// Speeds of `isolation` without a unit.
void add_speeds_of_isolation(const project::Case& variant, plausibility::Stated& stated) {
  const project::Node* isolation = find(variant.document, "requirements", "isolation");
  if (!isolation) return;
  const auto add = [&](const project::Node& speed) {
    if (speed.kind == project::Node::Kind::integer || speed.kind == project::Node::Kind::real)
      stated.speeds.push_back({"requirements.isolation.at", speed.number});
  };
  const auto add_of = [&](const project::Node& table) {
    const project::Node* at = table.kind == project::Node::Kind::table ? table.find("at") : nullptr;
    if (!at) return;
    if (at->kind != project::Node::Kind::array) return add(*at);
    for (const project::Node& item : at->items) add(item);
  };
  if (isolation->kind != project::Node::Kind::array) return add_of(*isolation);
  for (const project::Node& table : isolation->items) add_of(table);
}

/// The ranges in which [limits], [requirements.limits] and limit lines over the response are judged, and lines over
/// bands.
void add_limited_ranges(const project::Analyses& requested, plausibility::Stated& stated) {
  constexpr assembly::Band everywhere{0, foundation::infinity};
  const auto& response = requested.response;
  const auto& required = requested.requirements;
  const assembly::Band own = response && response->band ? *response->band : everywhere;
  const assembly::Band common = required && required->band ? *required->band : own;
  const std::string subject = required && required->band ? "requirements.band" : "analyses.response.band";
  const auto add = [&](const std::string& name, const assembly::Band& band) {
    stated.limited_ranges.push_back({name, band.from, band.to});
  };
  if (!requested.limits.empty()) add("analyses.response.band", own);
  if (required)
    for (const project::AmplitudeLimit& limit : required->limits) {
      const auto& band = limit.speed ? limit.speed : limit.band;
      add(band ? "requirements.limits" : subject, band.value_or(common));
    }
  if (requested.operation && (!requested.operation->limits.empty() || requested.operation->has_lines()))
    for (const assembly::Band& speed : requested.operation->speeds)
      add(requested.operation->limits.empty() ? "operation.bands" : "operation.limits", speed);
  for (const project::LimitLineRequest& request : requested.limit_lines) {
    const auto& points = request.line.angular_frequency;
    if (points.empty()) continue;
    if (request.bands)
      stated.band_lines.push_back(
          {"limit_lines." + request.line.name, points.front(), points.back(), request.excitations});
    else if (common.from <= points.back() && points.front() <= common.to)
      add("limit_lines." + request.line.name,
          {std::max(common.from, points.front()), std::min(common.to, points.back())});
  }
}

void add_analyses(const project::Case& variant, plausibility::Stated& stated) {
  const project::Analyses& requested = variant.analyses;
  const auto add = [&](const std::string& analysis, const std::optional<assembly::Band>& band) {
    if (band) stated.windows.push_back({"analyses." + analysis + ".band", band->from, band->to});
  };
  if (requested.response) add("response", requested.response->band);
  for (const auto& [analysis, band] : project::requested_bands(requested)) add(analysis, band);
  const assembly::MotionQuantity quantity =
      requested.response ? requested.response->selection.quantity : assembly::MotionQuantity::displacement;
  for (const project::Limit& limit : requested.limits)
    add_limit("limits", {limit.name, quantity, limit.amplitude}, stated);
  if (requested.requirements)
    for (const auto& [key, limits] : {std::pair{"limits", &requested.requirements->limits},
                                      {"steady", &requested.requirements->steady},
                                      {"static", &requested.requirements->statics}})
      for (const project::AmplitudeLimit& limit : *limits) add_limit(std::string("requirements.") + key, limit, stated);
  if (requested.operation)
    for (const project::AmplitudeLimit& limit : requested.operation->limits)
      add_limit("operation.limits", limit, stated);
  for (const project::LimitLineRequest& request : requested.limit_lines)
    if (const assembly::LimitLine& line = request.line; line.unit == "m" || line.unit == "m/s")
      stated.allowed_motions.push_back({request.of.substr(0, request.of.find('.')), "limit_lines." + line.name,
                                        request.of, std::ranges::max(line.limit), line.unit == "m/s", true});
  add_windows_of_requirements(variant, stated);
  add_limited_ranges(requested, stated);
  const project::Node* orders = find(variant.document, "analyses", "orders");
  const project::Node* speeds = orders ? orders->find("speed") : nullptr;
  const auto& run_up = requested.orders;
  if (run_up && speeds && speeds->items.size() == 2 && speeds->items[1].kind != project::Node::Kind::text)
    stated.speeds.push_back({"analyses.orders.speed", run_up->speed.to});
  add_speeds_of_isolation(variant, stated);
  for (const model::Excitation& excitation : variant.system.description().excitations)
    if (const auto* random = std::get_if<model::Random>(&excitation.course))
      stated.windows.push_back(
          {"excitations." + excitation.name + ".psd", random->spectrum.from(), random->spectrum.to(), true});
  if (const auto& in_time = requested.transient)
    stated.transient = plausibility::TimeAnalysis{in_time->to, in_time->selection.excitations};
}

/// Renames a subject to the foundation of the file: the impedance of a ground point has the name of its element.
void name_foundation(const project::Node& document, std::string& subject) {
  constexpr std::string_view group = "foundations.";
  if (!subject.starts_with(group)) return;
  const std::size_t dot = subject.find('.', group.size());
  const project::Node* element = find(document, "elements", subject.substr(group.size(), dot - group.size()));
  if (const project::Node* name = element ? element->find("foundation") : nullptr)
    subject = std::string(group) + name->text + (dot == std::string::npos ? "" : subject.substr(dot));
}

}  // namespace

std::vector<plausibility::Suspicion> suspicions(const project::Case& variant, const assembly::AssembledOnce& assembled,
                                                const std::vector<std::pair<std::string, std::string>>& accepted) {
  plausibility::Stated stated;
  add_bodies(variant, stated);
  add_rotors(variant, stated);
  add_analyses(variant, stated);
  stated.accepted = accepted;
  std::vector<plausibility::Suspicion> found = plausibility::suspicions(variant.system, assembled, stated);
  for (plausibility::Suspicion& one : found) name_foundation(variant.document, one.subject);
  return found;
}

foundation::Problems doubts_about_band(const project::Case& variant, const assembly::Band& band) {
  foundation::Problems ignored, doubts;
  const std::vector<Acceptance> accepted = read_acceptances(variant.document, ignored);
  const std::string table = "analyses.response";
  for (const plausibility::Suspicion& one :
       plausibility::suspicions_about(variant.system, {{table + ".band", band.from, band.to}})) {
    const bool known =
        std::ranges::any_of(accepted, [&](const Acceptance& a) { return a.table == table && a.kind == one.kind; });
    if (!known)
      doubts.warning("--band", one.finding, fmt::format("suspicion \"{}\": {}", one.kind, one.rule), one.probable);
  }
  return doubts;
}

void name_slips(const std::vector<model::Body>& bodies, const project::Node& document, foundation::Problems& problems) {
  for (const model::Body& body : bodies)
    for (foundation::Problem& problem : problems.list()) {
      if (problem.severity != foundation::Severity::error || problem.subject != "bodies." + body.name + ".inertia")
        continue;
      if (const auto slip = plausibility::slip_behind(body.mass, is_about_pole(document, body.name)))
        problem.remedy = slip->words + "; " + problem.remedy;
      break;  // one cause is named once
    }
}

}  // namespace trivet::judging
