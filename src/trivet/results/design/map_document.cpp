// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/results/design/map_cases.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/distinct_texts.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using json::Json;
using study::DesignMap;

Json axis_json(const project::DesignAxis& a) {
  return {{"parameter", a.parameter}, {"name", a.name},
          {"from", a.from},           {"to", a.to},
          {"unit", axis_unit(a)},     {"spacing", a.logarithmic ? "logarithmic" : "linear"},
          {"points", a.points}};
}

Json lines_json(const DesignMap& map, const std::vector<design::MapLine>& all) {
  Json list = Json::array();
  for (const design::MapLine& line : all) {
    Json points = Json::array();
    for (const design::MapPlace& p : line) points.push_back({map.request.x.at(p.x), map.request.y.at(p.y)});
    list.push_back(std::move(points));
  }
  return list;
}

Json governing_json(double margin, std::size_t rule) { return std::isinf(margin) ? Json("none") : Json(rule); }

Json best_json(const DesignMap& map) {
  if (!map.best) return nullptr;
  const design::DesignPoint p = map.point(*map.best);
  const design::DesignOutcome& outcome = map.outcomes[*map.best];
  return {{"x", p.x},
          {"y", p.y},
          {"margin", json::number(outcome.margin)},
          {"governing", governing_json(outcome.margin, outcome.governing)},
          {"kept", outcome.feasible()},
          {"without_bound", map.without_bound}};
}

/// Of the numbers of a rule: zero-to-peak of amplitudes; null if they have none.
Json level_of_rule(const design::MapRule& rule) {
  if (rule.kind == design::DesignRule::Kind::amplitude) return rule.unit == "1" ? Json() : Json("0-p");
  return rule.level.empty() ? Json() : Json(rule.level);
}

Json mark_json(const DesignMap& map, const study::MapMark& m) {
  Json result{{"case", m.name},
              {"x", json::optional(m.x)},
              {"y", json::optional(m.y)},
              {"of_this_model", m.of_this_model},
              {"has_own_rules", m.has_own_rules},
              {"decides", m.decides},
              {"words", verdict_words(map, m, Readers::programs)}};
  if (!m.judged) return result;
  result["kept"] = m.judged->governing.feasible();
  result["margin"] = json::number(m.judged->governing.margin);
  result["governing"] = governing_json(m.judged->governing.margin, m.judged->governing.rule);
  result["rules"] = Json::array();
  for (std::size_t r = 0; r < map.rules.size(); ++r) {
    const design::MapRule& rule = map.rules[r];
    const double value = m.judged->rules.values[r], margin = m.judged->margins[r];
    result["rules"].push_back({{"words", rule.words},
                               {"level", level_of_rule(rule)},
                               {"value", json::number(value)},
                               {"angular_frequency", json::number(m.judged->rules.angular_frequencies[r])},
                               {"allowed", rule.allowed},
                               {"margin", json::number(margin)},
                               {"kept", margin >= 1}});
  }
  result["peaks"] = Json::array();
  for (const response::Peak& peak : m.judged->peaks.list)
    result["peaks"].push_back({{"name", m.judged->peaks.curves[peak.curve].name},
                               {"unit", m.judged->peaks.curves[peak.curve].unit},
                               {"angular_frequency", peak.angular_frequency},
                               {"amplitude", json::number(peak.amplitude)},
                               {"relative_prominence", json::number(response::relative_prominence(peak))}});
  return result;
}

Json marks_json(const DesignMap& map) {
  Json list = Json::array();
  for (const study::MapMark& mark : map.marks) list.push_back(mark_json(map, mark));
  return list;
}

Json evaluation_json(const design::EvaluationReport& report) {
  Json result = {{"proven", report.proven}, {"redone", report.fallback}, {"one_by_one", report.assembled_separately}};
  if (report.with_requirements > 0) result["requirements"] = report.with_requirements;
  return result;
}

std::string kind_of_rule(const design::MapRule& rule) {
  if (rule.kind == design::DesignRule::Kind::requirement) return rule.requirement;
  return rule.kind == design::DesignRule::Kind::amplitude ? "amplitude" : "no_peak";
}

double share_of_designs(const DesignMap& map, std::size_t designs) {
  return static_cast<double>(designs) / static_cast<double>(map.outcomes.size());
}

/// The key of a picture.
Json colours_json(const DesignMap& map, const MapColours& colours) {
  Json list = Json::array();
  for (const std::size_t governing : colours.order()) {
    const bool none = governing == MapColours::unlimited;
    list.push_back(
        {{"governing", none ? Json("none") : Json(governing)},
         {"colour", colours.of(governing)},
         {"words", none ? "no rule limits it: " + unlimited_words(map) : rule_words(map, map.rules[governing])}});
  }
  if (map.unknown > 0)
    list.push_back(
        {{"governing", "not computed"}, {"colour", MapColours::not_computed}, {"words", not_computed_words}});
  return list;
}

/// People see the rules that govern some design.
Table rule_table(const DesignMap& map) {
  const Rows row(map.rules);
  const auto number = [&](const char* name, std::size_t study::RuleShare::* of) {
    return row(name, Kind::number, "", [&map, of](std::size_t r) { return map.shares[r].*of; });
  };
  const auto share = [&](const char* heading, std::size_t study::RuleShare::* of) {
    return row(heading, Kind::share, heading,
               [&map, of](std::size_t r) { return share_of_designs(map, map.shares[r].*of); }, {.forms = for_people});
  };
  return {
      .key = "rules",
      .rows = row.size(),
      .columns = {row("kind", Kind::words, "", kind_of_rule), row("name", Kind::words, "", &design::MapRule::channel),
                  row("unit", Kind::words, "", &design::MapRule::unit),
                  row("allowed", Kind::quantity, "", &design::MapRule::allowed),
                  row("level", Kind::words, "", level_of_rule), row("words", Kind::words, "", &design::MapRule::words),
                  row("rule", Kind::words, "rule",
                      [&map](const design::MapRule& rule) { return rule_words(map, rule); }, {.forms = for_people}),
                  number("governs_kept", &study::RuleShare::feasible),
                  number("governs_broken", &study::RuleShare::infeasible),
                  share("governs, infeasible", &study::RuleShare::infeasible),
                  share("governs, feasible", &study::RuleShare::feasible)},
      .people_rows = governing_rules(map)};
}

Table missing_table(const DesignMap& map) {
  using design::MissingReason;
  const Rows row(map.report.missing);
  const auto first = [&map](const MissingReason& one) { return map.point(one.first); };
  return {.key = "missing",
          .title = "Designs without a result",
          .rows = row.size(),
          .columns = {
              row("designs", Kind::number, "designs", &MissingReason::designs),
              row("reason", Kind::words, "", &MissingReason::words, {.forms = in_json}),
              row("first", Kind::words, "",
                  [first](const MissingReason& one) { return Json{first(one).x, first(one).y}; }, {.forms = in_json}),
              row("x", Kind::number, axis_name(map.request.x) + " of the first",
                  [first, &map](const MissingReason& one) { return axis_value(first(one).x, map.request.x); },
                  {.forms = for_people}),
              row("y", Kind::number, axis_name(map.request.y) + " of the first",
                  [first, &map](const MissingReason& one) { return axis_value(first(one).y, map.request.y); },
                  {.forms = for_people}),
              row("why", Kind::words, "reason", &MissingReason::words, {.forms = for_people})}};
}

std::string axis_words(const project::DesignAxis& axis) {
  const std::string name = axis_name(axis), path = name == axis.parameter ? "" : " (" + axis.parameter + ")",
                    unit = axis_unit(axis);
  const auto [from, to] = distinct_texts(axis.from, axis.to, 6);
  return fmt::format("{}{} {} … {}{}, {} points{}", name, path, from, to, unit.empty() ? "" : " " + unit, axis.points,
                     axis.logarithmic ? ", logarithmic" : "");
}

/// A note for coarse grids: a region smaller than a cell is missed.
std::string coarse_words(const DesignMap& map) {
  constexpr int enough = 21;
  const int fewest = std::min(map.grid.nx, map.grid.ny);
  return fewest >= enough
      ? ""
      : fmt::format(
            " (a coarse grid: a feasible region narrower than {:.0f} % of an axis may be missed; use more points)",
            100.0 / (fewest - 1));
}

Sentence note(std::string words) { return {.parts = {std::move(words)}, .place = Sentence::Place::note}; }

/// Designs that no rule limits, and rules that govern no design.
std::vector<Sentence> rule_notes(const DesignMap& map) {
  const std::vector<std::size_t> governing = governing_rules(map);
  std::size_t limited = 0;
  for (const std::size_t r : governing) limited += map.shares[r].feasible;
  std::vector<Sentence> notes;
  if (map.feasible_designs > limited)
    notes.push_back({.parts = {Quantity{share_of_designs(map, map.feasible_designs - limited), "1", Kind::share},
                               " of the designs are feasible because no rule limits them: " + unlimited_words(map)},
                     .place = Sentence::Place::note});
  if (governing.size() < map.rules.size())
    notes.push_back(
        note(fmt::format("{} of {} rules govern no design", map.rules.size() - governing.size(), map.rules.size())));
  return notes;
}

std::string title_words(const DesignMap& map) {
  return fmt::format("Map of {} designs{}: {}; {}", map.outcomes.size(),
                     map.case_name.empty() ? "" : " of case " + map.case_name, axis_words(map.request.x),
                     axis_words(map.request.y));
}

/// Maps of several pairs of parameters, side by side.
Table pairs_table(const std::vector<DesignMap>& maps) {
  const Rows row(maps);
  const auto best = [&](const char* heading, Kind kind, auto value) {
    return row(heading, kind, heading,
               [value](const DesignMap& map) -> Json {
                 if (!map.best) return nullptr;
                 return value(map, map.outcomes[*map.best]);
               },
               {.digits = 4});
  };
  using design::DesignOutcome;
  return {
      .title = fmt::format("Maps of {} pair{} of parameters; all others have the values of the file", maps.size(),
                           maps.size() == 1 ? "" : "s"),
      .rows = row.size(),
      .columns = {row("x", Kind::words, "x", [](const DesignMap& map) { return axis_name(map.request.x); }),
                  row("y", Kind::words, "y", [](const DesignMap& map) { return axis_name(map.request.y); }),
                  row("feasible", Kind::share, "feasible area", [](const DesignMap& map) { return map.feasible.area; }),
                  best("best x", Kind::number,
                       [](const DesignMap& map, const DesignOutcome&) {
                         return axis_value(map.point(*map.best).x, map.request.x);
                       }),
                  best("best y", Kind::number,
                       [](const DesignMap& map, const DesignOutcome&) {
                         return axis_value(map.point(*map.best).y, map.request.y);
                       }),
                  best("margin", Kind::number, [](const DesignMap&, const DesignOutcome& one) { return one.margin; }),
                  best("governed by", Kind::words,
                       [](const DesignMap& map, const DesignOutcome& one) {
                         return std::isinf(one.margin) ? "no rule" : rule_words(map, map.rules[one.governing]);
                       })},
      .forms = for_people};
}

}  // namespace

Document map_document(const DesignMap& map, Findings findings) {
  return map_document(map, MapColours({&map, 1}), findings);
}

Document map_document(const DesignMap& map, const MapColours& colours, Findings findings) {
  Document document;
  const auto json = [&](const char* name, Json value) {
    document.add(Single{.name = name, .value = std::move(value)});
  };
  document.add(Sentence{.parts = {title_words(map)}});
  json("case", map.case_name);
  json("x", axis_json(map.request.x));
  json("y", axis_json(map.request.y));
  json("band", map.request.band ? Json{map.request.band->from, map.request.band->to} : Json(nullptr));
  document.add(note("Criteria: " + criteria_words(map)));
  document.add(Sentence{.parts = {feasible_words(map) + coarse_words(map)}});
  document.add(Sentence{.parts = {best_words(map)}});
  for (const std::string& doubt : doubts(map))
    document.add(Sentence{.parts = {doubt}, .place = Sentence::Place::note, .forms = on_page});
  document.add(rule_table(map));
  for (Sentence& sentence : rule_notes(map)) document.add(std::move(sentence));
  json("colours", colours_json(map, colours));
  json("designs", map.outcomes.size());
  json("kept", map.feasible_designs);
  json("without_answer", map.unknown);
  json("feasible",
       {{"share", map.feasible.area},
        {"tolerance", map.boundary_tolerance},
        {"boundary", lines_json(map, map.feasible.lines)},
        {"rings", lines_json(map, map.feasible.rings)}});
  json("best", best_json(map));
  json("marks", marks_json(map));
  json("way", map.report.summary());
  json("evaluation", evaluation_json(map.report));
  document.add(missing_table(map));
  document.add(findings == Findings::all ? cases_on_map(map) : governing_on_map(map));
  document.add(note(map.report.summary()));
  return document;
}

Document map_pairs_document(const std::vector<DesignMap>& maps, Findings findings) {
  Document document{{{pairs_table(maps)}}};
  const MapColours colours(maps);
  for (const DesignMap& map : maps)
    document.add(Group{.key = "",
                       .parts = map_document(map, colours, findings).parts,
                       .title = axis_name(map.request.x) + " and " + axis_name(map.request.y)});
  return document;
}

}  // namespace trivet::results
