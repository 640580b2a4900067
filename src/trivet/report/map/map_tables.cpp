// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/report/map/map_picture.h"
#include "trivet/report/tables/analysis_tables.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::report {
namespace {

std::string value_or_dash(const std::optional<double>& value, const project::DesignAxis& axis) {
  return value ? results::axis_value(*value, axis) : "–";
}

std::string rules_table(const study::DesignMap& map) {
  std::vector<std::vector<Cell>> rows;
  const auto share = [&](std::size_t designs) {
    return percent_cell(static_cast<double>(designs) / static_cast<double>(map.outcomes.size()));
  };
  std::size_t limited = 0;
  for (const std::size_t r : results::governing_rules(map)) {
    rows.push_back(
        {{results::rule_words(map.rules[r])}, share(map.shares[r].infeasible), share(map.shares[r].feasible)});
    limited += map.shares[r].feasible;
  }
  if (map.feasible_designs > limited)
    rows.push_back(
        {{"no rule limits them: " + results::unlimited_words(map)}, right(""), share(map.feasible_designs - limited)});
  return html_table({{"rule"}, right("governs, infeasible"), right("governs, feasible")}, rows);
}

std::string marks_table(const study::DesignMap& map) {
  std::vector<std::vector<Cell>> rows;
  for (const study::MapMark& mark : map.marks) {
    std::string words;
    for (const std::string& sentence : results::verdict_words(map, mark))
      words += (words.empty() ? "" : "; ") + sentence;
    const bool feasible = mark.judged && mark.judged->governing.feasible();
    const Cell verdict = mark.judged
        ? Cell{feasible ? "meets every rule" : "violates a rule", false, feasible ? Tone::plain : Tone::bad}
        : missing_verdict_cell("not computed");
    rows.push_back({{mark.name.empty() ? "base model" : mark.name},
                    right(value_or_dash(mark.x, map.request.x)),
                    right(value_or_dash(mark.y, map.request.y)),
                    verdict,
                    {words + (mark.of_this_model ? "" : " (not the model of the map)")}});
  }
  return rows.empty() ? ""
                      : html_table({{"case"},
                                    right(results::axis_name(map.request.x)),
                                    right(results::axis_name(map.request.y)),
                                    {"verdict"},
                                    {"findings"}},
                                   rows);
}

}  // namespace

namespace {

std::string tables_of(const study::DesignMap& map) {
  std::string text = "Criteria: " + results::criteria_words(map) + ". " + results::feasible_words(map) + ".";
  if (map.best) text += " " + results::best_words(map) + ".";
  for (const design::MissingReason& reason : map.report.missing)
    text += fmt::format(" {} designs not computed, for instance: {}.", reason.designs, reason.words);
  for (const std::string& doubt : doubts(map)) text += " " + doubt;
  return rules_table(map) + hint(text + " " + map.report.summary() + ".") +
      folded("Cases on the map", marks_table(map));
}

}  // namespace

std::string map_tables(const study::CaseResults& results) {
  if (results.map) return tables_of(*results.map);
  std::string all;
  for (const study::DesignMap& map : results.map_pairs)
    all += folded(results::axis_name(map.request.x) + " and " + results::axis_name(map.request.y), tables_of(map));
  return all;
}

}  // namespace trivet::report
