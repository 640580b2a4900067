// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/design_judgement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "trivet/report/html_table.h"
#include "trivet/report/svg_canvas.h"
#include "trivet/results/map_verdicts.h"
#include "trivet/results/verdict_words.h"
#include "trivet/study/optimization.h"

namespace trivet::report {
namespace {

using Outcome = Judgement::Outcome;

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const std::string& part : parts)
    if (!part.empty()) text += (text.empty() ? "" : between) + part;
  return text;
}

std::string margin_words(double margin) { return std::isfinite(margin) ? fmt::format("margin {:.4g}", margin) : ""; }

std::string at_frequency(double omega, const project::ShownUnits& display) {
  if (!std::isfinite(omega)) return "towards ω = ∞";
  return fmt::format("at {:.5g} {}", results::shown_frequency(display, omega), results::frequency_unit(display));
}

void add_requirements(const study::CaseVerdict& verdict, std::size_t which, std::vector<Judgement>& list) {
  for (const results::RequirementRow& row : results::requirement_rows(verdict)) {
    const study::RequirementResult& result = *row.result;
    const bool clearance = result.kind == study::RequirementKind::clearance;
    Judgement one{Outcome::met,   clearance ? "clearance" : "requirement", row.words, "", result.margin, which,
                  verdict.decides};
    if (!result.value) {
      one.outcome = Outcome::not_judged;
      one.finding = result.reason;
    } else {
      if (!result.met()) one.outcome = verdict.decides ? Outcome::violated : Outcome::violated_no_need;
      const std::string place = row.place.empty() ? "" : "at " + row.place;
      one.finding = joined({joined({row.value, place}, " "), margin_words(result.margin)}, ", ");
    }
    list.push_back(std::move(one));
  }
}

/// Is this curve judged as a requirement that decides, too? @param name  of a limit line
bool is_required(const study::Answers& answers, study::RequirementKind kind, const std::string& subject,
                 const std::string& name = "") {
  if (!answers.verdict || !answers.verdict->decides) return false;
  const auto& results = answers.verdict->results;
  return std::any_of(results.begin(), results.end(), [&](const study::RequirementResult& r) {
    return r.kind == kind && r.subject == subject && (name.empty() || r.words.ends_with("\"" + name + "\""));
  });
}

void add_limits(const study::Answers& answers, std::size_t which, std::vector<Judgement>& list) {
  for (const study::LimitAnswer& limit : answers.limits) {
    if (is_required(answers, study::RequirementKind::amplitude, limit.name)) continue;
    const results::DisplayUnit unit = results::amplitude_unit(answers.display, limit.unit);
    list.push_back(
        {limit.met ? Outcome::met : Outcome::violated, "limit",
         fmt::format("{} ≤ {}", limit.name, results::value_text(limit.limit, unit)),
         fmt::format("{} {}, {} of the limit",
                     std::isfinite(limit.in_band) ? results::value_text(limit.in_band, unit) : "unbounded",
                     at_frequency(limit.in_band_at, answers.display), percent_cell(limit.in_band / limit.limit).text),
         limit.in_band > 0 ? limit.limit / limit.in_band : std::numeric_limits<double>::infinity(), which});
  }
  for (const study::LimitLineResult& line : answers.limit_lines) {
    if (is_required(answers, study::RequirementKind::limit_line, line.of, line.line.name)) continue;
    list.push_back({line.comparison.met() ? Outcome::met : Outcome::violated, "limit line",
                    fmt::format("{} within “{}”", line.of, line.line.name),
                    fmt::format("least margin {:.4g} dB {}", response::margin_level(line.comparison.least_margin),
                                at_frequency(line.comparison.least_margin_at, answers.display)),
                    line.comparison.least_margin, which});
  }
}

/// @param cases  in which the marks of the map are found by their names
void add_map(const study::DesignMap& map, std::size_t which, const std::vector<ShownCase>& cases,
             std::vector<Judgement>& list) {
  if (map.feasible_designs == 0)
    list.push_back({Outcome::violated, "map", "map of designs", "no design of the map meets every rule", 0, which});
  for (const study::MapMark& mark : map.marks) {
    const auto found =
        std::find_if(cases.begin(), cases.end(), [&](const ShownCase& c) { return c.answers.case_name == mark.name; });
    Judgement one{Outcome::not_judged,
                  "map",
                  "rules of the map",
                  joined(results::verdict_words(map, mark), "; "),
                  0,
                  found == cases.end() ? which : static_cast<std::size_t>(found - cases.begin())};
    if (mark.judged) {
      one.outcome = mark.judged->governing.feasible() ? Outcome::met : Outcome::violated;
      one.margin = mark.judged->governing.margin;
    }
    list.push_back(std::move(one));
  }
}

std::size_t number_with(const std::vector<Judgement>& list, Outcome outcome) {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [&](const Judgement& j) { return j.outcome == outcome; }));
}

/// "2 of 9 requirements, 1 of 1 limit": of those that decide, and of what is not judged elsewhere.
std::string shares_words(const std::vector<Judgement>& list, Outcome outcome) {
  static constexpr std::array kinds = {"requirement", "clearance",   "limit", "limit line",
                                       "map",         "best design", "answer"};
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

/// A list with the worst first; the rest is counted.
std::string listed_judgements(std::vector<Judgement> list, Outcome outcome, const std::vector<ShownCase>& cases) {
  constexpr std::size_t most = 6;
  std::erase_if(list, [&](const Judgement& j) { return j.outcome != outcome; });
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.margin < b.margin; });
  std::string items;
  for (std::size_t i = 0; i < std::min(most, list.size()); ++i) {
    const std::string where = cases.size() > 1 ? " (" + cases[list[i].shown_case].name() + ")" : "";
    items += "<li><strong>" + escaped(list[i].words) + "</strong>" +
        (list[i].finding.empty() ? "" : ": " + escaped(list[i].finding)) + "<span class=\"where\">" + escaped(where) +
        "</span></li>\n";
  }
  if (list.size() > most) items += fmt::format("<li>and {} more, see below</li>\n", list.size() - most);
  return "<ul>" + items + "</ul>";
}

std::string judgement_part(const std::string& style, const std::string& title, const std::string& html) {
  return fmt::format("<div class=\"{}\" role=\"note\"><h2>{}</h2>{}</div>\n", style, escaped(title), html);
}

/// The judged one with the least margin; nullptr if nothing limits the design.
const Judgement* least_of(const std::vector<Judgement>& list) {
  const Judgement* least = nullptr;
  for (const Judgement& one : list)
    if (one.outcome == Outcome::met && one.decides && std::isfinite(one.margin) &&
        (!least || one.margin < least->margin))
      least = &one;
  return least;
}

}  // namespace

std::vector<Judgement> judgements(const std::vector<ShownCase>& cases) {
  std::vector<Judgement> list;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const study::Answers& answers = cases[i].answers;
    if (answers.verdict) add_requirements(*answers.verdict, i, list);
    add_limits(answers, i, list);
    if (answers.map) add_map(*answers.map, i, cases, list);
    for (const study::DesignMap& map : answers.map_pairs) add_map(map, i, cases, list);
    if (answers.optimization)
      list.push_back({answers.optimization->feasible ? Outcome::met : Outcome::violated, "best design",
                      "best design of the search",
                      answers.optimization->feasible ? "" : "no design that was found meets every requirement",
                      std::numeric_limits<double>::infinity(), i});
    for (const std::string& failure : answers.failures)
      if (std::none_of(list.begin(), list.end(),
                       [&](const Judgement& one) { return one.shown_case == i && one.finding == failure; }))
        list.push_back({Outcome::not_judged, "answer", "not computed", failure, 0, i});
  }
  return list;
}

std::string judgement_box(const std::vector<ShownCase>& cases) {
  const std::vector<Judgement> list = judgements(cases);
  const std::size_t violated = number_with(list, Outcome::violated), missing = number_with(list, Outcome::not_judged),
                    no_need = number_with(list, Outcome::violated_no_need), met = number_with(list, Outcome::met);
  const bool bad_data =
      std::any_of(cases.begin(), cases.end(), [](const ShownCase& c) { return !c.failed_checks().empty(); });
  std::string html;
  if (violated > 0)
    html += judgement_part("alert", "✗ VIOLATED: " + shares_words(list, Outcome::violated),
                           listed_judgements(list, Outcome::violated, cases));
  if (missing > 0)
    html += judgement_part("doubt", "? NOT JUDGED: " + shares_words(list, Outcome::not_judged),
                           listed_judgements(list, Outcome::not_judged, cases));
  std::string beside;
  if (no_need > 0)
    beside = paragraph("Violated in cases in which the design need not hold:") +
        listed_judgements(list, Outcome::violated_no_need, cases);
  if (violated + missing == 0 && met > 0) {
    const Judgement* least = least_of(list);
    const std::string governing = !least
        ? ""
        : "<p>Least margin: <strong>" + escaped(least->words) + "</strong>, " + escaped(least->finding) +
            (cases.size() > 1 ? " <span class=\"where\">(" + escaped(cases[least->shown_case].name()) + ")</span>"
                              : "") +
            "</p>";
    const std::string title = "MET: " + shares_words(list, Outcome::met);
    html += bad_data ? judgement_part("doubt", "? " + title + "; but checks of the data failed, see below", governing)
                     : judgement_part("calm", "✓ " + title, governing);
  }
  if (list.empty())
    html += paragraph("The design is not judged: the file has no requirements, limits, clearances or map.", "note");
  if (!beside.empty()) html += "<div class=\"note\" role=\"note\">" + beside + "</div>\n";
  return html;
}

}  // namespace trivet::report
