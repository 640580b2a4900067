// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_text.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/text_table.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/distinct_texts.h"

namespace trivet::results {
namespace {

std::string point_words(const study::DesignMap& map, const design::DesignPoint& p) {
  const project::DesignAxis &x = map.request.x, &y = map.request.y;
  return fmt::format("{} = {}, {} = {}", axis_name(x), axis_value(p.x, x), axis_name(y), axis_value(p.y, y));
}

std::string axis_words(const project::DesignAxis& axis) {
  const std::string name = axis_name(axis), path = name == axis.parameter ? "" : " (" + axis.parameter + ")",
                    unit = axis_unit(axis);
  const auto [from, to] = distinct_texts(axis.from, axis.to, 6);
  return fmt::format("{}{} {} … {}{}, {} points{}", name, path, from, to, unit.empty() ? "" : " " + unit, axis.points,
                     axis.logarithmic ? ", logarithmic" : "");
}

/// A note for coarse grids: a region smaller than a cell is missed.
std::string coarse_words(const study::DesignMap& map) {
  constexpr int enough = 21;
  const int fewest = std::min(map.grid.nx, map.grid.ny);
  return fewest >= enough
      ? ""
      : fmt::format(
            " (a coarse grid: a feasible region narrower than {:.0f} % of an axis may be missed; use more points)",
            100.0 / (fewest - 1));
}

std::string shares_text(const study::DesignMap& map) {
  TextTable table({"rule", "governs, infeasible", "governs, feasible"});
  const auto percent = [&](std::size_t designs) {
    return fmt::format("{:.1f} %", 100.0 * static_cast<double>(designs) / static_cast<double>(map.outcomes.size()));
  };
  const std::vector<std::size_t> governing = governing_rules(map);
  std::size_t limited = 0;
  for (const std::size_t r : governing) {
    table.add({rule_words(map.rules[r]), percent(map.shares[r].infeasible), percent(map.shares[r].feasible)});
    limited += map.shares[r].feasible;
  }
  if (map.feasible_designs > limited)
    table.add({"no rule limits them: " + unlimited_words(map), "", percent(map.feasible_designs - limited)});
  const std::size_t silent = map.rules.size() - governing.size();
  return table.text() +
      (silent > 0 ? fmt::format("  {} of {} rules govern no design\n", silent, map.rules.size()) : "");
}

std::string mark_text(const study::DesignMap& map, const study::MapMark& mark) {
  const auto place = [&](const std::optional<double>& value, const project::DesignAxis& axis) {
    return value ? axis_value(*value, axis) : std::string("not in the file");
  };
  std::string text = fmt::format("  {} ({}, {}): {}", mark.name.empty() ? "base model" : mark.name,
                                 place(mark.x, map.request.x), place(mark.y, map.request.y),
                                 !mark.judged                            ? "NOT COMPUTED"
                                     : mark.judged->governing.feasible() ? "meets every rule"
                                                                         : "VIOLATES the rules");
  if (!mark.of_this_model) text += "; its model differs by more than the two numbers";
  text += "\n";
  for (const std::string& words : verdict_words(map, mark)) text += "      " + words + "\n";
  return text;
}

}  // namespace

std::string map_text(const study::DesignMap& map) {
  std::string text = fmt::format("Map of {} designs{}: {}; {}\n", map.outcomes.size(),
                                 map.case_name.empty() ? "" : " of case " + map.case_name, axis_words(map.request.x),
                                 axis_words(map.request.y));
  text += "  " + criteria_words(map) + "\n";
  text += feasible_words(map) + coarse_words(map) + "\n";
  if (map.best) text += best_words(map) + "\n";
  text += shares_text(map);
  for (const design::MissingReason& reason : map.report.missing)
    text += fmt::format("  {} design{} without a result, {}at {}: {}\n", reason.designs, reason.designs == 1 ? "" : "s",
                        reason.designs == 1 ? "" : "the first one ", point_words(map, map.point(reason.first)),
                        reason.words);
  if (!map.marks.empty()) text += "Cases\n";
  for (const study::MapMark& mark : map.marks) text += mark_text(map, mark);
  return text + "  " + map.report.summary() + "\n";
}

std::string map_pairs_text(const std::vector<study::DesignMap>& maps) {
  TextTable table({"x", "y", "feasible", "best x", "best y", "margin", "governed by"});
  for (const study::DesignMap& map : maps) {
    const project::DesignAxis &x = map.request.x, &y = map.request.y;
    std::vector<std::string> row = {axis_name(x), axis_name(y), fmt::format("{:.2f} %", 100 * map.feasible.area)};
    if (map.best) {
      const design::DesignPoint p = map.point(*map.best);
      const design::DesignOutcome& best = map.outcomes[*map.best];
      const bool unlimited = std::isinf(best.margin);
      for (std::string& word : std::vector<std::string>{axis_value(p.x, x), axis_value(p.y, y),
                                                        unlimited ? "∞" : fmt::format("{:.4g}", best.margin),
                                                        unlimited ? "no rule" : rule_words(map.rules[best.governing])})
        row.push_back(std::move(word));
    }
    row.resize(7);
    table.add(row);
  }
  std::string text = fmt::format("Maps of {} pair{} of parameters; all others have the values of the file\n{}\n",
                                 maps.size(), maps.size() == 1 ? "" : "s", table.text());
  for (const study::DesignMap& map : maps) text += map_text(map) + "\n";
  return text;
}

}  // namespace trivet::results
