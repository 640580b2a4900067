// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/judgements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "trivet/documents/shown_table.h"
#include "trivet/documents/text_table.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/design/sample_document.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/study/optimize/optimization.h"

namespace trivet::results {
namespace {

using Outcome = Judgement::Outcome;

std::string without_empty(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const std::string& part : parts)
    if (!part.empty()) text += (text.empty() ? "" : between) + part;
  return text;
}

std::string finite_margin_words(double margin) {
  return std::isfinite(margin) ? fmt::format("margin {:.4g}", margin) : "";
}

std::string at_frequency(double omega, const project::DisplayUnits& display) {
  if (!std::isfinite(omega)) return "towards ω = ∞";
  return fmt::format("at {:.5g} {}", shown_frequency(display, omega), frequency_unit(display));
}

void add_requirements(const study::CaseVerdict& verdict, std::size_t which, std::vector<Judgement>& list) {
  for (const std::size_t i : by_margin(verdict)) {
    const study::RequirementResult& result = verdict.results[i];
    const bool clearance = result.kind == study::RequirementKind::clearance;
    Judgement one{Outcome::met,
                  clearance ? "clearance" : "requirement",
                  requirement_words(result, verdict.display),
                  "",
                  result.margin,
                  which,
                  verdict.decides};
    if (!result.words.bound.empty())
      one.subject = result.words.judged, one.bound = bound_words(result, verdict.display);
    if (!result.value) {
      one.outcome = Outcome::not_judged;
      one.finding = result.reason;
    } else {
      if (!result.met()) one.outcome = verdict.decides ? Outcome::violated : Outcome::violated_no_need;
      const std::string value = judged_value(result, verdict.display), place = judged_place(result, verdict.display);
      const bool is_at = result.angular_frequency || result.time;  // not only a detail
      one.value = value, one.place = place, one.is_at = is_at;
      one.finding = without_empty({without_empty({value, is_at ? "at " + place : ""}, " "), is_at ? "" : place,
                                   finite_margin_words(result.margin)},
                                  ", ");
    }
    list.push_back(std::move(one));
  }
}

/// "5.316 mm/s rms of 3.2 mm/s rms" where a curve is nearest to its line; empty if it is unbounded there.
std::string value_on_line(const study::LimitLineResult& found, const project::DisplayUnits& display) {
  const double margin = found.comparison.least_margin, at = found.comparison.least_margin_at;
  if (!(margin > 0) || !std::isfinite(margin) || !std::isfinite(at)) return "";
  DisplayUnit unit = display_unit(display, found.line.unit);
  unit.level = found.line.rms ? " rms" : " 0-p";
  const double limit = response::zero_to_peak_limit(found.line, at) *
      project::level_factor(found.line.rms ? project::Level::rms : project::Level::amplitude);
  return value_text(limit / margin, unit) + " of " + value_text(limit, unit);
}

void add_limits(const study::CaseResults& case_results, std::size_t which, std::vector<Judgement>& list) {
  for (const study::LimitResult* alone : limits_alone(case_results)) {
    const study::LimitResult& limit = *alone;
    const DisplayUnit unit = amplitude_unit(case_results.display, limit.unit);
    list.push_back({limit.met ? Outcome::met : Outcome::violated, "limit",
                    fmt::format("{} ≤ {}", limit.name, value_text(limit.limit, unit)),
                    fmt::format("{} {}, {} of the limit",
                                std::isfinite(limit.in_band) ? value_text(limit.in_band, unit) : "unbounded",
                                at_frequency(limit.in_band_at, case_results.display),
                                std::isfinite(limit.in_band) ? percent(limit.in_band / limit.limit) : "∞"),
                    limit.in_band > 0 ? limit.limit / limit.in_band : std::numeric_limits<double>::infinity(), which});
    Judgement& one = list.back();
    one.subject = limit.name;
    one.bound = "≤ " + value_text(limit.limit, unit);
    one.value = std::isfinite(limit.in_band) ? value_text(limit.in_band, unit) : "∞";
    one.place = shown_quantity({.value = limit.in_band_at, .kind = Kind::frequency}, case_results.display);
    one.is_at = std::isfinite(limit.in_band_at);
  }
  for (const study::LimitLineResult* alone : limit_lines_alone(case_results)) {
    const study::LimitLineResult& line = *alone;
    const std::string value = value_on_line(line, case_results.display);
    list.push_back({line.comparison.met() ? Outcome::met : Outcome::violated, "limit line",
                    fmt::format("{} within “{}”", line.of, line.line.name),
                    fmt::format("{}{}least margin {} dB {}", value, value.empty() ? "" : ", ",
                                documents::number_text(response::margin_level(line.comparison.least_margin), 4),
                                at_frequency(line.comparison.least_margin_at, case_results.display)),
                    line.comparison.least_margin, which});
    Judgement& one = list.back();
    const double level = response::margin_level(line.comparison.least_margin);
    one.subject = line.of;
    one.bound = "within “" + line.line.name + "”";
    const std::string distance =
        fmt::format("{} dB {} the line", documents::number_text(std::abs(level), 4), level < 0 ? "above" : "below");
    one.value = value.empty() ? distance : value + ", " + distance;
    one.place =
        shown_quantity({.value = line.comparison.least_margin_at, .kind = Kind::frequency}, case_results.display);
    one.is_at = std::isfinite(line.comparison.least_margin_at);
  }
}

/// Lines over bands at the speeds of the machine.
void add_operating_lines(const study::CaseResults& case_results, std::size_t which, std::vector<Judgement>& list) {
  for (const study::OperatingLine* line : operating_lines_alone(case_results)) {
    Judgement one{line->met() ? Outcome::met : Outcome::violated, "limit line"};
    one.subject = line->of;
    one.bound = fmt::format("within “{}” {} {}", line->line.name, line->speed.from < line->speed.to ? "over" : "at",
                            study::speed_words(line->speed));
    one.words = one.subject + " " + one.bound;
    one.margin = line->margin();
    one.shown_case = which;
    one.value = "no order in its bands";
    if (line->nearest) {
      const DisplayUnit unit = root_mean_square_unit(case_results.display, line->line.unit);
      const double level = line->nearest->with_random();
      one.value = fmt::format("{} of {}", std::isfinite(level) ? value_text(level, unit) : "∞",
                              value_text(line->nearest->limit, unit));
      one.place = fmt::format("{:.4g} Hz", line->nearest->band.nominal_hz());
      if (const std::string remark = line->remark(); !remark.empty()) one.place += ", " + remark;
      one.is_at = true;
    }
    one.finding = without_empty(
        {without_empty({one.value, one.is_at ? "at " + one.place : ""}, " "), finite_margin_words(one.margin)}, ", ");
    list.push_back(std::move(one));
  }
}

/// The first findings of a map, which has many rules; all are listed with it.
std::string first_findings(std::vector<std::string> words) {
  constexpr std::size_t most = 3;
  if (words.size() > most + 1) {
    const std::size_t more = words.size() - most;
    words.resize(most);
    words.push_back(fmt::format("and {} more, listed with the map", more));
  }
  return without_empty(words, "; ");
}

/// The least margin of the rules that a case on the map is charged with: a rule of another case on it counts there.
double own_margin(const study::DesignMap& map, const study::MapMark& mark) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < map.rules.size(); ++r) {
    const std::string& of_case = map.rules[r].in_case;
    const bool counts_there = !of_case.empty() && of_case != mark.name &&
        std::ranges::any_of(map.marks, [&](const study::MapMark& one) { return one.name == of_case && one.judged; });
    if (counts_there) continue;
    const double margin = mark.judged->margins[r];
    if (std::isnan(margin)) return margin;  // unknown
    least = std::min(least, margin);
  }
  return least;
}

/// @param cases  in which the marks of the map are found by their names
void add_map(const study::DesignMap& map, std::size_t which, const std::vector<const study::CaseResults*>& cases,
             std::vector<Judgement>& list) {
  if (map.feasible_designs == 0)
    list.push_back({Outcome::violated, "map", "map of designs", "no design of the map meets every rule", 0, which});
  for (const study::MapMark& mark : map.marks) {
    const auto found =
        std::ranges::find_if(cases, [&](const study::CaseResults* one) { return one->case_name == mark.name; });
    Judgement one{Outcome::not_judged,
                  "map",
                  "rules of the map",
                  first_findings(verdict_words(map, mark)),
                  0,
                  found == cases.end() ? which : static_cast<std::size_t>(found - cases.begin()),
                  mark.decides};
    if (mark.judged) {
      const bool feasible = mark.judged->governing.feasible();
      one.margin = feasible ? mark.judged->governing.margin : own_margin(map, mark);
      one.outcome = one.margin >= 1 ? Outcome::met : mark.decides ? Outcome::violated : Outcome::violated_no_need;
      if (!feasible && one.outcome == Outcome::met) one.finding = "meets its rules";
    }
    list.push_back(std::move(one));
  }
}

/// What decides on a wanted yield that the designs do not decide.
std::string deciding_words(const study::Sample& sample) {
  if (sample.first_of) return "trivet sample judges more designs";
  const std::optional<double> designs = sample.yield.deciding(*sample.request.yield);
  if (sample.yield.met == sample.yield.designs)
    return fmt::format("without violations {:.0f} designs show it", *designs);
  return designs ? fmt::format("about {:.0f} designs decide if the share stays", *designs) : "more designs decide";
}

/// The wanted yield of designs within tolerances.
void add_yield(const study::CaseResults& case_results, std::size_t which, std::vector<Judgement>& list) {
  if (!case_results.sample || !case_results.sample->request.yield) return;
  const study::Sample& sample = *case_results.sample;
  const double wanted = *sample.request.yield;
  Judgement one{.outcome = Outcome::met,
                .kind = "yield",
                .words = "the machines within tolerances have the wanted yield",
                .finding = yield_words(sample.yield, wanted),
                .margin = std::numeric_limits<double>::infinity(),
                .shown_case = which,
                .is_of_search = true};
  if (sample.yield_verdict() == study::YieldVerdict::violated) {
    one.outcome = Outcome::violated;
    one.words = "too few machines within tolerances meet every requirement";
    one.margin = 0;
  } else if (sample.yield_verdict() == study::YieldVerdict::undecided) {
    one.outcome = Outcome::not_judged;
    one.words = "the wanted yield of the machines within tolerances is not decided";
    one.finding += "; " + deciding_words(sample);
  }
  list.push_back(std::move(one));
}

/// Curves of motions that end before the end that was requested.
void add_cut_short(const study::CaseResults& case_results, std::size_t which, std::vector<Judgement>& list) {
  const auto add = [&](const char* analysis, const std::string& ended) {
    if (!ended.empty())
      list.push_back({Outcome::not_judged, "answer", fmt::format("{} is not complete", analysis), ended, 0, which});
  };
  if (const auto& steady = case_results.steady) add("steady", steady->ended);
  if (const auto& modes = case_results.backbone)
    for (const nonlinear::Backbone& mode : *modes) add("backbone", mode.ended);
}

}  // namespace

std::vector<std::string> failed_checks(const std::vector<study::CheckLine>& checks,
                                       const study::CaseResults& case_results) {
  std::vector<std::string> failed;
  for (const study::CheckLine& line : checks)
    if (!line.passed) failed.push_back(line.subject + ", “" + line.what + "”: " + line.value);
  if (case_results.response && !case_results.response->deep.passed)
    failed.push_back("response: the second solver does not agree");
  return failed;
}

std::string count_words(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::size_t number_with(const std::vector<Judgement>& list, Outcome outcome) {
  return static_cast<std::size_t>(std::ranges::count(list, outcome, &Judgement::outcome));
}

/// "2 of 9 requirements, 1 of 1 limit": of those that decide, and of what is not judged elsewhere.
std::string shares_words(const std::vector<Judgement>& list, Outcome outcome) {
  static constexpr std::array kinds = {"requirement", "clearance",   "limit", "limit line",
                                       "map",         "best design", "yield", "answer"};
  std::string words;
  for (const std::string kind : kinds) {
    std::size_t all = 0, these = 0;
    for (const Judgement& one : list) {
      const bool unknown = outcome == Outcome::not_judged && one.outcome == outcome;
      if (one.kind != kind || !(one.decides || unknown)) continue;
      ++all;
      these += one.outcome == outcome;
    }
    if (these == 0) continue;
    const std::string what = kind == "map" ? "verdict" : kind;
    words += (words.empty() ? "" : ", ") + fmt::format("{} of {}", these, count_words(all, what)) +
        (kind == "map" ? " of a map" : "");
  }
  return words;
}

std::string elsewhere_words(const std::vector<Judgement>& list) {
  std::set<std::size_t> cases;
  for (const Judgement& one : list)
    if (one.outcome == Outcome::violated_no_need) cases.insert(one.shown_case);
  return cases.empty()
      ? ""
      : fmt::format("; violated in {} in which they are not binding", count_words(cases.size(), "case"));
}

std::vector<Judgement> judgements(const std::vector<const study::CaseResults*>& cases) {
  std::vector<Judgement> list;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const study::CaseResults& case_results = *cases[i];
    if (case_results.verdict) add_requirements(*case_results.verdict, i, list);
    add_limits(case_results, i, list);
    add_operating_lines(case_results, i, list);
    if (case_results.map) add_map(*case_results.map, i, cases, list);
    for (const study::DesignMap& map : case_results.map_pairs) add_map(map, i, cases, list);
    if (const auto& optimum = case_results.optimization)
      list.push_back({.outcome = optimum->feasible ? Outcome::met : Outcome::violated,
                      .kind = "best design",
                      .words = best_design_words(*optimum),
                      .finding = objective_change(*optimum),
                      .margin = std::numeric_limits<double>::infinity(),
                      .shown_case = i,
                      .is_of_search = true});
    add_yield(case_results, i, list);
    add_cut_short(case_results, i, list);
    for (const std::string& failure : case_results.failures)
      if (std::ranges::none_of(list,
                               [&](const Judgement& one) { return one.shown_case == i && one.finding == failure; }))
        list.push_back({Outcome::not_judged, "answer", "not computed", failure, 0, i});
  }
  return list;
}

const Judgement* least_of(const std::vector<Judgement>& list) {
  const Judgement* least = nullptr;
  for (const Judgement& one : list)
    if (one.outcome == Outcome::met && one.decides && std::isfinite(one.margin) &&
        (!least || one.margin < least->margin))
      least = &one;
  return least;
}

}  // namespace trivet::results
