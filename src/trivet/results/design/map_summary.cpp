// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/shown_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/distinct_texts.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/explain/explanation.h"
#include "trivet/study/map/map_warnings.h"

namespace trivet::results {

namespace {

/// A peak within the tolerance is called slight only if it is hardly visible in the curve.
std::string peak_words(bool counted, double tallest) {
  constexpr double slight = 0.05;
  return counted ? "peaks" : tallest <= slight ? "rises within the tolerance" : "has a peak within the tolerance";
}

/// "8.25 %", "1010 %": how far a peak rises above the adjacent minimum.
std::string height_words(double prominence) {
  constexpr double whole = 100;  // from 100 % on without decimals, and never with a power of ten
  const double share = 100 * prominence;
  return std::isinf(share) ? "unbounded"
      : share < whole      ? fmt::format("{:.3g} %", share)
                           : fmt::format("{:.0f} %", share);
}

std::string requirement_value(const design::MapRule& rule, double value, const project::DisplayUnits& display) {
  if (std::isinf(value)) return "unbounded";
  if (rule.unit == "rad/s") return shown_quantity({.value = value, .kind = Kind::frequency}, display);
  return rule.unit == "1" ? fmt::format("{:.4g}", value) : study::value_words(value, rule.unit);
}

std::string frequency_words(const project::DisplayUnits& display, double omega) {
  return fmt::format("{:.4g} {}", shown_frequency(display, omega), frequency_unit(display));
}

/// Lengths and forces of maps stay in SI; frequencies and levels are those of the display.
project::DisplayUnits units_for_people(const study::DesignMap& map) {
  project::DisplayUnits units;
  units.frequency = map.display.frequency;
  units.level = map.display.level;
  return units;
}

/// Unit and factor of the amplitude of a rule.
DisplayUnit rule_unit(const design::MapRule& rule, const project::DisplayUnits& display, Readers readers) {
  return readers == Readers::people ? amplitude_unit(display, rule.unit) : display_unit(display, rule.unit);
}

/// The same in sentences: for people with the prefix that suits the limit.
UnitPrefix words_unit(const design::MapRule& rule, const project::DisplayUnits& display, Readers readers) {
  const DisplayUnit unit = rule_unit(rule, display, readers);
  return readers == Readers::people ? unit_prefix(rule.allowed, unit) : UnitPrefix{unit.factor, unit.label()};
}

/// " 0-p" behind a value of a requirement that people read.
std::string level_after(const design::MapRule& rule, double value, Readers readers) {
  return readers == Readers::people && !rule.shown_level.empty() && std::isfinite(value) ? " " + rule.shown_level : "";
}

/// The words of a rule beside a mark, without the case if that is the mark's own.
std::string words_beside(const study::DesignMap& map, const study::MapMark& mark, design::MapRule rule,
                         Readers readers) {
  if (rule.in_case == mark.name) rule.unset_case();
  return readers == Readers::people ? rule_words(map, rule) : rule.words;
}

/// Are the peaks of this rule among those of the model of the mark, which are listed together?
bool lists_peaks(const study::DesignMap& map, const study::MapMark& mark, const design::MapRule& rule) {
  return (rule.in_case.empty() || rule.in_case == mark.name) &&
      std::ranges::any_of(map.rules, [&](const design::MapRule& other) {
           return other.kind == rule.kind && other.in_case.empty() && other.channel == rule.channel &&
               other.unit == rule.unit;
         });
}

/// Numbers of the rules: those with an unknown margin, then the others from the least margin on.
std::vector<std::size_t> rules_by_margin(const std::vector<double>& margins) {
  std::vector<std::size_t> order(margins.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t r) { return std::isnan(margins[r]) ? -foundation::infinity : margins[r]; });
  return order;
}

}  // namespace

std::vector<std::string> verdict_words(const study::DesignMap& map, const study::MapMark& mark, Readers readers) {
  project::DisplayUnits display = units_for_people(map);
  if (readers == Readers::programs) {
    display = {};
    display.frequency = map.in_hertz ? "Hz" : "rad/s";
  }
  std::vector<std::string> words;
  if (mark.has_own_rules)
    words.push_back(fmt::format("judged by the rules of this map; its own map has other rules: {}",
                                mark.name.empty() ? "map without --case" : "map --case \"" + mark.name + "\""));
  if (!mark.judged) {
    words.push_back("not computed: " + mark.failure);
    return words;
  }
  const design::JudgedDesign& judged = *mark.judged;
  const auto add = [&](const std::string& line) {  // a rule of a further case may be one of the map too
    if (std::ranges::find(words, line) == words.end()) words.push_back(line);
  };
  for (const std::size_t r : rules_by_margin(judged.margins)) {
    const design::MapRule& rule = map.rules[r];
    const double value = judged.rules.values[r], at = judged.rules.angular_frequencies[r];
    if (rule.kind == design::DesignRule::Kind::requirement && judged.margins[r] < 1)
      add(fmt::format("{}: {}{}, margin {:.4g}", words_beside(map, mark, rule, readers),
                      requirement_value(rule, readers == Readers::people ? value * rule.shown_factor : value, display),
                      level_after(rule, value, readers), judged.margins[r]));
    if (rule.kind == design::DesignRule::Kind::no_peak && judged.margins[r] < 1 && !lists_peaks(map, mark, rule))
      add(fmt::format("{}{} peaks at {} ({})", rule.channel, rule.case_words(), frequency_words(display, at),
                      height_words(value)));
    if (rule.kind != design::DesignRule::Kind::amplitude || judged.margins[r] >= 1) continue;
    const std::string of_case = rule.in_case == mark.name ? "" : rule.case_words(),
                      where = std::isinf(at) ? "towards ω = ∞" : "at " + frequency_words(display, at);
    const UnitPrefix unit = words_unit(rule, display, readers);
    if (std::isinf(value)) {
      add(fmt::format("{}{} is unbounded {}, allowed {:.4g} {}", rule.channel, of_case, where,
                      rule.allowed * unit.factor, unit.unit));
      continue;
    }
    const auto [reached, allowed] = distinct_texts(value * unit.factor, rule.allowed * unit.factor, 4);
    add(fmt::format("{}{} reaches {} {} {}, allowed {} {}", rule.channel, of_case, reached, unit.unit, where, allowed,
                    unit.unit));
  }
  const design::DesignRule no_peak{design::DesignRule::Kind::no_peak, 0, map.request.peak_tolerance};
  for (const bool counted : {true, false})
    for (std::size_t c = 0; c < judged.peaks.curves.size(); ++c) {
      const std::string& name = judged.peaks.curves[c].name;
      const bool ruled = std::ranges::any_of(map.rules, [&](const design::MapRule& r) {
        return r.kind == design::DesignRule::Kind::no_peak && r.channel == name &&
            r.unit == judged.peaks.curves[c].unit;
      });
      std::string list;
      double tallest = 0;
      for (const response::Peak& peak : judged.peaks.list) {
        const double prominence = response::relative_prominence(peak);
        if (!ruled || peak.curve != c || (design::margin(no_peak, prominence) < 1) != counted) continue;
        tallest = std::max(tallest, prominence);
        list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", frequency_words(display, peak.angular_frequency),
                            height_words(prominence));
      }
      if (!list.empty()) words.push_back(fmt::format("{} {} at {}", name, peak_words(counted, tallest), list));
    }
  if (judged.governing.feasible())
    words.push_back(std::isinf(judged.governing.margin)
                        ? "no rule limits it"
                        : fmt::format("least margin {:.4g}: {}", judged.governing.margin,
                                      words_beside(map, mark, map.rules[judged.governing.rule], readers)));
  return words;
}

namespace {

using RuleKind = design::DesignRule::Kind;

bool has(const study::DesignMap& map, RuleKind kind) {
  return std::ranges::any_of(map.rules, [&](const design::MapRule& rule) { return rule.kind == kind; });
}

std::string band_words(const std::optional<assembly::Band>& band, const project::DisplayUnits& display) {
  if (!band) return "amplitudes over all frequencies";
  const auto [from, to] = distinct_texts(shown_frequency(display, band->from), shown_frequency(display, band->to), 6);
  return fmt::format("amplitudes over {} … {} {}", from, to, frequency_unit(display));
}

}  // namespace

std::string criteria_words(const study::DesignMap& map) {
  std::string text;
  if (has(map, RuleKind::amplitude)) text = band_words(map.request.band, map.display);
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

std::string rule_words(const study::DesignMap& map, const design::MapRule& rule) {
  if (rule.kind != RuleKind::amplitude) return rule.stated();
  const DisplayUnit unit = rule_unit(rule, units_for_people(map), Readers::people);
  return fmt::format("{} ≤ {}{}", rule.channel, value_text(rule.allowed, unit), rule.case_words());
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
  const std::string rule = rule_words(map, map.rules[best.governing]);
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

std::vector<std::string> doubts(const study::DesignMap& map) {
  std::vector<std::string> sentences;
  for (const foundation::Problem& warning : map.warnings.list()) {
    const std::string subject = warning.subject.starts_with("map: ") ? warning.subject.substr(5) + ": " : "";
    sentences.push_back(fmt::format("Warning: {}{}; {}.", subject, warning.finding, warning.rule));
  }
  return sentences;
}

}  // namespace trivet::results
