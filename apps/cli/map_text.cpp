// SPDX-License-Identifier: BSD-3-Clause
#include "cli/map_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/text_table.h"
#include "trivet/study/axis_words.h"
#include "trivet/study/map_verdicts.h"
#include "trivet/study/shown_apart.h"

namespace trivet::cli {
namespace {

std::string margin_words(double margin) { return std::isinf(margin) ? "∞" : fmt::format("{:.4g}", margin); }

std::string point_words(const study::DesignMap& map, const study::DesignPoint& p) {
  return fmt::format("{} = {}, {} = {}", map.request.x.name, study::axis_value(p.x, map.request.x), map.request.y.name, study::axis_value(p.y, map.request.y));
}

std::string axis_words(const study::MapAxis& axis) {
  const std::string path = axis.name == axis.parameter ? "" : " (" + axis.parameter + ")";
  const std::string unit = study::axis_unit(axis);
  const auto [from, to] = study::shown_apart(axis.from, axis.to, 6);
  return fmt::format("{}{} {} … {}{}, {} points{}", axis.name, path, from, to, unit.empty() ? "" : " " + unit, axis.points, axis.logarithmic ? ", logarithmic" : "");
}

std::string band_words(const response::Band& band) {
  const auto [from, to] = study::shown_apart(band.from, band.to, 6);
  return fmt::format("amplitudes over {} … {} rad/s", from, to);
}

/// What the rules of this map are asked of.
std::string rules_text(const study::DesignMap& map) {
  const auto has = [&](response::DesignRule::Kind kind) { return std::any_of(map.rules.begin(), map.rules.end(), [&](const study::MapRule& rule) { return rule.kind == kind; }); };
  std::string text;
  if (has(response::DesignRule::Kind::amplitude))
    text = map.request.band ? band_words(*map.request.band) : "amplitudes over all frequencies";
  if (has(response::DesignRule::Kind::no_peak))
    text += fmt::format("{}resonance peaks wherever they lie, from {:g} % above the minimum beside them", text.empty() ? "" : "; ", 100 * map.request.peak_tolerance);
  return "  " + text + "\n";
}

/// A region smaller than a cell of the grid is not seen.
std::string coarse_words(const study::DesignMap& map) {
  constexpr int enough = 21;
  const int fewest = std::min(map.grid.nx, map.grid.ny);
  return fewest >= enough ? "" : fmt::format(" (a coarse grid: regions below {:.0f} % of an axis are not seen; take more points)", 100.0 / (fewest - 1));
}

std::string shares_text(const study::DesignMap& map) {
  std::vector<std::size_t> order(map.rules.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return map.shares[a].broken + map.shares[a].kept > map.shares[b].broken + map.shares[b].kept; });
  TextTable table({"rule", "governs, broken", "governs, kept"});
  const auto percent = [&](std::size_t designs) { return fmt::format("{:.1f} %", 100.0 * static_cast<double>(designs) / static_cast<double>(map.outcomes.size())); };
  int silent = 0;
  for (const std::size_t r : order) {
    if (map.shares[r].broken + map.shares[r].kept == 0) ++silent;
    else table.add({map.rules[r].words, percent(map.shares[r].broken), percent(map.shares[r].kept)});
  }
  std::size_t limited = 0;
  for (const study::RuleShare& share : map.shares) limited += share.kept;
  if (map.kept > limited) table.add({"no rule limits them: no peak", "", percent(map.kept - limited)});
  return table.text() + (silent > 0 ? fmt::format("  {} of {} rules govern nowhere\n", silent, map.rules.size()) : "");
}

std::string mark_text(const study::DesignMap& map, const study::MapMark& mark) {
  const auto place = [&](const std::optional<double>& value, const study::MapAxis& axis) { return value ? study::axis_value(*value, axis) : std::string("not in the file"); };
  std::string text = fmt::format("  {} ({}, {}): {}", mark.name.empty() ? "base model" : mark.name, place(mark.x, map.request.x), place(mark.y, map.request.y),
                                 !mark.judged ? "NOT COMPUTED" : mark.judged->governing.kept() ? "keeps every rule" : "BREAKS the rules");
  if (!mark.of_this_model) text += ", a model of its own beside the two numbers";
  text += "\n";
  for (const std::string& words : study::verdict_words(map, mark)) text += "      " + words + "\n";
  return text;
}

}  // namespace

std::string map_text(const study::DesignMap& map) {
  std::string text = fmt::format("Map of {} designs{}: {}; {}\n", map.outcomes.size(), map.case_name.empty() ? "" : " of case " + map.case_name, axis_words(map.request.x), axis_words(map.request.y));
  text += rules_text(map);
  text += study::feasible_words(map) + coarse_words(map) + "\n";
  if (map.best) {
    const study::DesignOutcome& best = map.outcomes[*map.best];
    text += fmt::format("{}: {}; margin {} ({})\n", best.kept() ? "Best design" : "No design keeps every rule; the nearest", point_words(map, map.point(*map.best)), margin_words(best.margin),
                        std::isinf(best.margin) ? fmt::format("no rule limits {} designs; of these the one farthest from all others and from the frame", map.without_bound)
                                                : map.rules[best.governing].words + (best.margin > 0 && map.equals > 1 ? fmt::format("; in the midst of {} as good ones", map.equals) : ""));
  }
  text += shares_text(map);
  for (const study::MissingReason& reason : map.report.missing)
    text += fmt::format("  {} design{} without an answer, {}{}: {}\n", reason.designs, reason.designs == 1 ? "" : "s", reason.designs == 1 ? "" : "the first ", point_words(map, map.point(reason.first)),
                        reason.words);
  if (!map.marks.empty()) text += "Cases\n";
  for (const study::MapMark& mark : map.marks) text += mark_text(map, mark);
  return text + "  " + map.report.words() + "\n";
}

}  // namespace trivet::cli
