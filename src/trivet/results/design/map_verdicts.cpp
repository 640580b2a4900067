// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/results/format/distinct_texts.h"
#include "trivet/study/explain/explanation.h"

namespace trivet::results {
namespace {

/// A peak within the tolerance is called slight only if it is hardly visible in the curve.
std::string peak_words(bool counted, double tallest) {
  constexpr double slight = 0.05;
  return counted ? "peaks" : tallest <= slight ? "rises within the tolerance" : "has a peak within the tolerance";
}

std::string requirement_value(const design::MapRule& rule, double value) {
  if (std::isinf(value)) return "unbounded";
  if (rule.unit == "rad/s") return fmt::format("{:.5g} Hz", value / foundation::two_pi);
  return rule.unit == "1" ? fmt::format("{:.4g}", value) : study::value_words(value, rule.unit);
}

std::string frequency_words(const study::DesignMap& map, double omega) {
  return map.in_hertz ? fmt::format("{:.4g} Hz", omega / foundation::two_pi) : fmt::format("{:.4g} rad/s", omega);
}

/// The words of a rule beside a mark, without the case if that is the mark's own.
std::string words_beside(const study::MapMark& mark, const design::MapRule& rule) {
  return rule.in_case == mark.name ? rule.words.substr(0, rule.words.size() - rule.case_words().size()) : rule.words;
}

/// Are the peaks of this rule among those of the model of the mark, which are listed together?
bool lists_peaks(const study::DesignMap& map, const study::MapMark& mark, const design::MapRule& rule) {
  return (rule.in_case.empty() || rule.in_case == mark.name) &&
      std::ranges::any_of(map.rules, [&](const design::MapRule& other) {
           return other.kind == rule.kind && other.in_case.empty() && other.answer == rule.answer &&
               other.unit == rule.unit;
         });
}

}  // namespace

std::vector<std::string> verdict_words(const study::DesignMap& map, const study::MapMark& mark) {
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
  for (std::size_t r = 0; r < map.rules.size(); ++r) {
    const design::MapRule& rule = map.rules[r];
    const double value = judged.rules.values[r], at = judged.rules.angular_frequencies[r];
    if (rule.kind == design::DesignRule::Kind::requirement && judged.margins[r] < 1)
      add(fmt::format("{}: {}, margin {:.4g}", words_beside(mark, rule), requirement_value(rule, value),
                      judged.margins[r]));
    if (rule.kind == design::DesignRule::Kind::no_peak && judged.margins[r] < 1 && !lists_peaks(map, mark, rule))
      add(fmt::format("{}{} peaks at {} ({})", rule.answer, rule.case_words(), frequency_words(map, at),
                      std::isinf(value) ? "unbounded" : fmt::format("{:.3g} %", 100 * value)));
    if (rule.kind != design::DesignRule::Kind::amplitude || judged.margins[r] >= 1) continue;
    const std::string of_case = rule.in_case == mark.name ? "" : rule.case_words(),
                      where = std::isinf(at) ? "towards ω = ∞" : "at " + frequency_words(map, at);
    if (std::isinf(value)) {
      add(fmt::format("{}{} is unbounded {}, allowed {:.4g} {}", rule.answer, of_case, where, rule.allowed, rule.unit));
      continue;
    }
    const auto [reached, allowed] = distinct_texts(value, rule.allowed, 4);
    add(fmt::format("{}{} reaches {} {} {}, allowed {}", rule.answer, of_case, reached, rule.unit, where, allowed));
  }
  const design::DesignRule no_peak{design::DesignRule::Kind::no_peak, 0, map.request.peak_tolerance};
  for (const bool counted : {true, false})
    for (std::size_t c = 0; c < judged.peaks.curves.size(); ++c) {
      const std::string& name = judged.peaks.curves[c].name;
      const bool ruled = std::ranges::any_of(map.rules, [&](const design::MapRule& r) {
        return r.kind == design::DesignRule::Kind::no_peak && r.answer == name && r.unit == judged.peaks.curves[c].unit;
      });
      std::string list;
      double tallest = 0;
      for (const response::Peak& peak : judged.peaks.list) {
        const double prominence = response::relative_prominence(peak);
        if (!ruled || peak.curve != c || (design::margin(no_peak, prominence) < 1) != counted) continue;
        tallest = std::max(tallest, prominence);
        list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", frequency_words(map, peak.angular_frequency),
                            std::isinf(prominence) ? "unbounded" : fmt::format("{:.3g} %", 100 * prominence));
      }
      if (!list.empty()) words.push_back(fmt::format("{} {} at {}", name, peak_words(counted, tallest), list));
    }
  if (judged.governing.feasible())
    words.push_back(std::isinf(judged.governing.margin)
                        ? "no rule limits it"
                        : fmt::format("least margin {:.4g}: {}", judged.governing.margin,
                                      words_beside(mark, map.rules[judged.governing.rule])));
  return words;
}

}  // namespace trivet::results
