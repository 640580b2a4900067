// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "trivet/documents/csv_field.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using json::Json;

Json axis(const project::DesignAxis& a) {
  return {{"parameter", a.parameter}, {"name", a.name},
          {"from", a.from},           {"to", a.to},
          {"unit", axis_unit(a)},     {"spacing", a.logarithmic ? "logarithmic" : "linear"},
          {"points", a.points}};
}

std::string kind(const design::MapRule& rule) {
  if (rule.kind == design::DesignRule::Kind::requirement) return rule.requirement;
  return rule.kind == design::DesignRule::Kind::amplitude ? "amplitude" : "no_peak";
}

Json rules(const study::DesignMap& map) {
  Json list = Json::array();
  for (std::size_t r = 0; r < map.rules.size(); ++r) {
    const design::MapRule& rule = map.rules[r];
    list.push_back({{"kind", kind(rule)},
                    {"name", rule.channel},
                    {"unit", rule.unit},
                    {"allowed", rule.allowed},
                    {"words", rule.words},
                    {"governs_kept", map.shares[r].feasible},
                    {"governs_broken", map.shares[r].infeasible}});
  }
  return list;
}

Json lines(const study::DesignMap& map, const std::vector<design::MapLine>& all) {
  Json list = Json::array();
  for (const design::MapLine& line : all) {
    Json points = Json::array();
    for (const design::MapPlace& p : line) points.push_back({map.request.x.at(p.x), map.request.y.at(p.y)});
    list.push_back(std::move(points));
  }
  return list;
}

/// Passes a text to a sink in pieces.
class Pieces {
 public:
  explicit Pieces(const TextSink& sink) : sink_(sink) {}
  std::string& text() {
    if (text_.size() >= piece) hand_on();
    return text_;
  }
  void hand_on() {
    sink_(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t piece = 1 << 16;
  const TextSink& sink_;
  std::string text_;
};

/// Margins and governing rules; a margin is null if the design has none or no rule limits it.
void write_grid(const study::DesignMap& map, Pieces& out) {
  out.text() += "{\"order\":\"row after row of y, x running\",\"margin\":[";
  const char* separator = "";
  for (const design::DesignOutcome& outcome : map.outcomes) {
    if (outcome.known() && std::isfinite(outcome.margin))
      fmt::format_to(std::back_inserter(out.text()), "{}{}", separator, outcome.margin);
    else (out.text() += separator) += "null";
    separator = ",";
  }
  out.text() += "],\"governing\":[";
  separator = "";
  for (const design::DesignOutcome& outcome : map.outcomes) {
    out.text() += separator;
    if (!outcome.known())
      out.text() += outcome.governing == design::DesignOutcome::no_model ? "\"no model\"" : "\"not computed\"";
    else if (std::isinf(outcome.margin)) out.text() += "\"none\"";
    else fmt::format_to(std::back_inserter(out.text()), "{}", outcome.governing);
    separator = ",";
  }
  out.text() += "]}";
}

Json governing(double margin, std::size_t rule) { return std::isinf(margin) ? Json("none") : Json(rule); }

Json mark(const study::DesignMap& map, const study::MapMark& m) {
  Json result{{"case", m.name},
              {"x", json::optional(m.x)},
              {"y", json::optional(m.y)},
              {"of_this_model", m.of_this_model},
              {"has_own_rules", m.has_own_rules},
              {"words", verdict_words(map, m)}};
  if (!m.judged) return result;
  result["kept"] = m.judged->governing.feasible();
  result["margin"] = json::number(m.judged->governing.margin);
  result["governing"] = governing(m.judged->governing.margin, m.judged->governing.rule);
  result["rules"] = Json::array();
  for (std::size_t r = 0; r < map.rules.size(); ++r) {
    const design::MapRule& rule = map.rules[r];
    const double value = m.judged->rules.values[r], margin = m.judged->margins[r];
    result["rules"].push_back({{"words", rule.words},
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

Json without_grid(const study::DesignMap& map) {
  Json result{{"case", map.case_name}, {"x", axis(map.request.x)}, {"y", axis(map.request.y)}};
  result["band"] = map.request.band ? Json{map.request.band->from, map.request.band->to} : Json(nullptr);
  result["rules"] = rules(map);
  result["designs"] = map.outcomes.size();
  result["kept"] = map.feasible_designs;
  result["without_answer"] = map.unknown;
  result["feasible"] = {{"share", map.feasible.area},
                        {"tolerance", map.boundary_tolerance},
                        {"boundary", lines(map, map.feasible.lines)},
                        {"rings", lines(map, map.feasible.rings)}};
  result["best"] = nullptr;
  if (map.best) {
    const design::DesignPoint p = map.point(*map.best);
    const design::DesignOutcome& outcome = map.outcomes[*map.best];
    result["best"] = {{"x", p.x},
                      {"y", p.y},
                      {"margin", json::number(outcome.margin)},
                      {"governing", governing(outcome.margin, outcome.governing)},
                      {"kept", outcome.feasible()},
                      {"without_bound", map.without_bound}};
  }
  result["marks"] = Json::array();
  for (const study::MapMark& m : map.marks) result["marks"].push_back(mark(map, m));
  result["way"] = map.report.summary();
  result["evaluation"] = {
      {"proven", map.report.proven}, {"redone", map.report.fallback}, {"one_by_one", map.report.assembled_separately}};
  if (map.report.with_requirements > 0) result["evaluation"]["requirements"] = map.report.with_requirements;
  result["missing"] = Json::array();
  for (const design::MissingReason& reason : map.report.missing) {
    const design::DesignPoint p = map.point(reason.first);
    result["missing"].push_back({{"designs", reason.designs}, {"reason", reason.words}, {"first", {p.x, p.y}}});
  }
  return result;
}

}  // namespace

Json json::design_map(const study::DesignMap& map) {
  Json result = without_grid(map);
  std::string grid;
  const TextSink sink = [&](std::string_view piece) { grid += piece; };
  Pieces pieces(sink);
  write_grid(map, pieces);
  pieces.hand_on();
  result["grid"] = Json::parse(grid);
  return result;
}

namespace {

void write_with_grid(const Json& rest, const study::DesignMap& map, const TextSink& sink) {
  std::string head = json::text(rest);
  head.pop_back();
  Pieces pieces(sink);
  pieces.text() += head + ",\"grid\":";
  write_grid(map, pieces);
  pieces.text() += "}";
  pieces.hand_on();
}

}  // namespace

void write_map_json(const study::DesignMap& map, const foundation::Problems& warnings, const TextSink& sink) {
  Json result = without_grid(map);
  result["warnings"] = json::warnings(warnings);
  write_with_grid(result, map, sink);
  sink("\n");
}

void write_map_pairs_json(const std::vector<study::DesignMap>& maps, const foundation::Problems& warnings,
                          const TextSink& sink) {
  sink("{\"pairs\":[");
  for (std::size_t k = 0; k < maps.size(); ++k) {
    if (k > 0) sink(",");
    write_with_grid(without_grid(maps[k]), maps[k], sink);
  }
  sink("],\"warnings\":" + json::text(json::warnings(warnings)) + "}\n");
}

namespace {

std::string column_head(const project::DesignAxis& a) {
  return csv_field(axis_unit(a).empty() ? a.name : a.name + " [" + axis_unit(a) + "]");
}

/// @param before  the first fields of each row, with a comma behind
void write_rows(const study::DesignMap& map, const std::string& before, Pieces& pieces) {
  std::vector<std::string> words;
  for (const design::MapRule& rule : map.rules) words.push_back(csv_field(rule.words));
  for (std::size_t k = 0; k < map.outcomes.size(); ++k) {
    const design::DesignPoint p = map.point(k);
    const design::DesignOutcome& o = map.outcomes[k];
    std::string& text = pieces.text();
    fmt::format_to(std::back_inserter(text), "{}{},{},", before, p.x, p.y);
    if (o.known())
      fmt::format_to(std::back_inserter(text), "{},{},{}\n", o.margin,
                     std::isinf(o.margin) ? "none" : words[o.governing], o.feasible() ? "yes" : "no");
    else text += o.governing == design::DesignOutcome::no_model ? ",no model,no\n" : ",not computed,no\n";
  }
}

std::string in_one_text(const std::function<void(const TextSink&)>& write) {
  std::string text;
  write([&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace

void write_map_csv(const study::DesignMap& map, const TextSink& sink) {
  Pieces pieces(sink);
  pieces.text() += column_head(map.request.x) + "," + column_head(map.request.y) + ",margin,governing,kept\n";
  write_rows(map, "", pieces);
  pieces.hand_on();
}

void write_map_pairs_csv(const std::vector<study::DesignMap>& maps, const TextSink& sink) {
  Pieces pieces(sink);
  pieces.text() += "x parameter,y parameter,x,y,margin,governing,kept\n";
  for (const study::DesignMap& map : maps)
    write_rows(map, column_head(map.request.x) + "," + column_head(map.request.y) + ",", pieces);
  pieces.hand_on();
}

std::string map_pairs_csv(const std::vector<study::DesignMap>& maps) {
  return in_one_text([&](const TextSink& sink) { write_map_pairs_csv(maps, sink); });
}

std::string map_csv(const study::DesignMap& map) {
  return in_one_text([&](const TextSink& sink) { write_map_csv(map, sink); });
}

}  // namespace trivet::results
