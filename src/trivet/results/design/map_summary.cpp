// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/distinct_texts.h"
#include "trivet/study/explain/explanation.h"
#include "trivet/study/map/map_warnings.h"

namespace trivet::results {
namespace {

using RuleKind = design::DesignRule::Kind;

bool has(const study::DesignMap& map, RuleKind kind) {
  return std::ranges::any_of(map.rules, [&](const design::MapRule& rule) { return rule.kind == kind; });
}

std::string band_words(const std::optional<assembly::Band>& band, bool in_hertz) {
  if (!band) return "amplitudes over all frequencies";
  const double unit = in_hertz ? foundation::two_pi : 1;
  const auto [from, to] = distinct_texts(band->from / unit, band->to / unit, 6);
  return fmt::format("amplitudes over {} … {} {}", from, to, in_hertz ? "Hz" : "rad/s");
}

}  // namespace

std::string asked_words(const study::DesignMap& map) {
  std::string text;
  if (has(map, RuleKind::amplitude)) text = band_words(map.request.band, map.in_hertz);
  if (has(map, RuleKind::no_peak))
    text += fmt::format(
        "{}resonance peaks at all frequencies, from {:g} % above the adjacent minimum (rises below {:g} of the curve "
        "maximum are ignored)",
        text.empty() ? "" : "; ", 100 * map.request.peak_tolerance, map.request.min_prominence);
  const auto others = std::ranges::count(map.rules, RuleKind::requirement, &design::MapRule::kind);
  if (others > 0)
    text += fmt::format("{}{} {}requirement{}", text.empty() ? "" : "; ", others, text.empty() ? "" : "other ",
                        others == 1 ? "" : "s");
  return text;
}

std::string rule_words(const design::MapRule& rule) {
  if (rule.kind != RuleKind::amplitude) return rule.words;
  return fmt::format("{} ≤ {}{}", rule.answer, study::value_words(rule.allowed, rule.unit), rule.case_words());
}

std::string feasible_words(const study::DesignMap& map) {
  const std::string share = fmt::format("{:.2f} %", 100 * map.feasible.area);
  const bool rounded_up =
      share == "100.00 %" && (map.feasible_designs < map.outcomes.size() || map.band_crossings.pairs > 0);
  std::string text = fmt::format("Feasible: {} of the map, {} of {} designs", rounded_up ? "less than 100 %" : share,
                                 map.feasible_designs, map.outcomes.size());
  if (map.steep > 0)
    text += fmt::format(
        "; the margin changes more than tenfold within {} of neighbouring designs governed by amplitude limits: a "
        "design between them, at a lightly damped resonance for instance, may violate a rule unnoticed; use more "
        "points there",
        map.steep == 1 ? "one pair" : fmt::format("{} pairs", map.steep));
  if (std::ranges::any_of(map.marks, [&](const study::MapMark& mark) { return study::contradicts(map, mark); }))
    text += "; unreliable: a case is feasible where all designs around it are not, or the reverse; use more points";
  return text;
}

std::string best_words(const study::DesignMap& map) {
  if (!map.best) return "";
  const design::DesignOutcome& best = map.outcomes[*map.best];
  const design::DesignPoint p = map.point(*map.best);
  const project::DesignAxis &x = map.request.x, &y = map.request.y;
  const std::string place =
      fmt::format("{} = {}, {} = {}", axis_name(x), axis_value(p.x, x), axis_name(y), axis_value(p.y, y));
  if (std::isinf(best.margin))
    return fmt::format("Best design: {}; margin ∞ (no rule limits {} designs; this one is in the middle of them)",
                       place, map.without_bound);
  const std::string rule = rule_words(map.rules[best.governing]);
  if (best.margin == 0)
    return fmt::format("No design is feasible and all have margin 0 ({}); the middle one: {}", rule, place);
  std::string text = fmt::format(
      "{}: {}; margin {:.4g} ({}{})", best.feasible() ? "Best design" : "No design is feasible; the nearest", place,
      best.margin, rule, map.equals > 1 ? fmt::format("; the middle one of {} equally good designs", map.equals) : "");
  const std::vector<std::string> ends = best_ends(map);
  for (std::size_t k = 0; k < ends.size(); ++k) text += (k == 0 ? "; at " : " and ") + ends[k];
  return text + (ends.empty() ? "" : ", a better one may lie beyond");
}

std::vector<std::string> best_ends(const study::DesignMap& map) {
  if (!map.best || !(map.outcomes[*map.best].margin > 0) || std::isinf(map.outcomes[*map.best].margin)) return {};
  const auto nx = to_size(map.grid.nx), ny = to_size(map.grid.ny);
  const design::DesignPoint p = map.point(*map.best);
  std::vector<std::string> ends;
  const auto look = [&](const project::DesignAxis& axis, double value, std::size_t at, std::size_t points) {
    if (value != 0 && (at == 0 || at + 1 == points))
      ends.push_back(fmt::format("the {} end of {}", at == 0 ? "lower" : "upper", axis_name(axis)));
  };
  look(map.request.x, p.x, *map.best % nx, nx);
  look(map.request.y, p.y, *map.best / nx, ny);
  return ends;
}

std::vector<std::size_t> governing_rules(const study::DesignMap& map) {
  const auto designs = [&](std::size_t rule) { return map.shares[rule].infeasible + map.shares[rule].feasible; };
  std::vector<std::size_t> order(map.rules.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return designs(a) > designs(b); });
  std::erase_if(order, [&](std::size_t rule) { return designs(rule) == 0; });
  return order;
}

std::string unlimited_words(const study::DesignMap& map) {
  if (has(map, RuleKind::requirement)) return "nothing to judge";
  return has(map, RuleKind::amplitude) ? "no motion" : "no peak";
}

}  // namespace trivet::results
