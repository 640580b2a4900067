// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/design_judgement.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/results/design/judgements.h"

namespace trivet::report {
namespace {

using results::Judgement;
using Outcome = Judgement::Outcome;

/// A list with the worst first; the rest is counted.
std::string listed_judgements(std::vector<Judgement> list, Outcome outcome, const std::vector<ShownCase>& cases,
                              bool linked) {
  constexpr std::size_t most = 6;
  std::erase_if(list, [&](const Judgement& j) { return j.outcome != outcome; });
  std::ranges::stable_sort(list, [](const auto& a, const auto& b) { return a.margin < b.margin; });
  std::string items;
  for (std::size_t i = 0; i < std::min(most, list.size()); ++i) {
    const ShownCase& shown = cases[list[i].shown_case];
    const results::JudgementSentence words =
        results::judgement_sentence(list[i], shown.results.case_name, cases.size() > 1);
    const std::string subject = "<strong>" + escaped(words.subject) + "</strong>";
    const std::string link =
        fmt::format("<a href=\"#case={0}\" data-select=\"{0}\">{1}</a>", list[i].shown_case, subject);
    const std::string before = words.who.empty() ? "" : escaped(words.who) + " " + words.verb + " ";
    items += fmt::format("<li>{}{}{}</li>\n", before, linked ? link : subject, escaped(words.rest));
  }
  if (list.size() > most)
    items += fmt::format("<li><a href=\"#judgements\">and {} more</a></li>\n", list.size() - most);
  return "<ul>" + items + "</ul>";
}

std::vector<Judgement> judgements_of(const std::vector<ShownCase>& cases) {
  std::vector<const study::CaseResults*> results;
  for (const ShownCase& one : cases) results.push_back(&one.results);
  return results::judgements(results);
}

std::string judgement_part(const std::string& style, const std::string& title, const std::string& html) {
  return fmt::format("<div class=\"{}\" role=\"note\"><h2>{}</h2>{}</div>\n", style, escaped(title), html);
}

}  // namespace

std::string judgements_table(const std::vector<ShownCase>& cases, const project::DisplayUnits& display) {
  std::vector<std::string> names;
  for (const ShownCase& one : cases) names.push_back(one.results.case_name);
  return as_html(results::judgements_document(judgements_of(cases), names), display);
}

std::string judgement_box(const std::vector<ShownCase>& cases, bool linked) {
  const std::vector<Judgement> list = judgements_of(cases);
  const std::size_t violated = number_with(list, Outcome::violated), missing = number_with(list, Outcome::not_judged),
                    no_need = number_with(list, Outcome::violated_no_need), met = number_with(list, Outcome::met);
  const bool bad_data = std::ranges::any_of(cases, [](const ShownCase& c) { return !c.failed_checks().empty(); });
  std::string html;
  if (violated > 0)
    html += judgement_part("alert", "✗ VIOLATED: " + shares_words(list, Outcome::violated),
                           listed_judgements(list, Outcome::violated, cases, linked));
  if (missing > 0)
    html += judgement_part("doubt", "? NOT JUDGED: " + shares_words(list, Outcome::not_judged),
                           listed_judgements(list, Outcome::not_judged, cases, linked));
  std::string beside;
  if (no_need > 0)
    beside = paragraph("Violated in cases in which the requirements are not binding:") +
        listed_judgements(list, Outcome::violated_no_need, cases, linked);
  if (violated + missing == 0 && met > 0) {
    const Judgement* least = least_of(list);
    const std::string governing = !least
        ? ""
        : "<p>Least margin: <strong>" + escaped(least->words) + "</strong>, " + escaped(least->finding) +
            (cases.size() > 1 ? " <span class=\"where\">(" + escaped(cases[least->shown_case].name()) + ")</span>"
                              : "") +
            "</p>";
    const std::string title = "MET: " + shares_words(list, Outcome::met) + results::elsewhere_words(list);
    if (bad_data)
      html += judgement_part("doubt", "? " + title + "; but checks of the data failed, see below", governing);
    else
      html += no_need > 0 ? judgement_part("doubt", title, governing) : judgement_part("calm", "✓ " + title, governing);
  }
  if (list.empty()) html += paragraph(results::nothing_judged, "note");
  if (!beside.empty()) html += "<div class=\"note\" role=\"note\">" + beside + "</div>\n";
  return html;
}

}  // namespace trivet::report
