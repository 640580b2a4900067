// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/page_notices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "trivet/documents/html_table.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/report/page/design_judgement.h"
#include "trivet/results/design/sample_document.h"

namespace trivet::report {

namespace {

Row check_row(const std::string& subject, const std::string& what, const std::string& value, bool passed) {
  return {{{subject}, {what}, {value}, verdict_cell(passed)}, passed ? "" : "failed"};
}

/// A value to know, without a verdict.
Row information_row(const std::string& what, const std::string& value) {
  return {{{"response"}, {what}, {value}, {}}, ""};
}

std::string undefined_words(const std::vector<double>& undefined_at, const project::DisplayUnits& display) {
  std::string words;
  for (const double omega : undefined_at)
    words += fmt::format("{}{:.6g}", words.empty() ? "" : ", ", results::shown_frequency(display, omega));
  return words.empty() ? "none" : words + " " + results::frequency_unit(display);
}

std::vector<Row> solution_rows(const study::ResponseResult& result, const project::DisplayUnits& display) {
  const auto at = [&display](double omega) {
    return fmt::format("at {:.5g} {}", results::shown_frequency(display, omega), results::frequency_unit(display));
  };
  const response::SolutionCheck& check = result.curves.check;
  const response::DeepCheck& deep = result.deep;
  std::vector<Row> rows = {
      information_row("worst backward error of the solution",
                      fmt::format("{:.3g} {}", check.worst_backward_error, at(check.at_angular_frequency))),
      check_row("response",
                fmt::format("second solver agrees at {} {}", deep.frequencies,
                            deep.frequencies == 1 ? "frequency" : "frequencies"),
                fmt::format("worst difference {:.3g} {}, allowed {:.3g}", deep.worst_difference,
                            at(deep.at_angular_frequency), deep.allowed),
                deep.passed),
      information_row("frequencies that needed the pivoted solver", std::to_string(check.fallbacks)),
      information_row("frequencies at which the response is not defined",
                      undefined_words(check.undefined_at, display))};
  if (result.model) {
    constexpr double allowed = 1e-3;  // of a plot, see response::CurveModelOptions
    const response::CurveModel& model = *result.model;
    rows.push_back(check_row("response", "curves of this page compared with independent solves and extrema",
                             fmt::format("drawn from {} {}; largest difference {:.2g} % {}, {} compared", model.solves,
                                         model.solves == 1 ? "solve" : "solves", 100 * model.worst_error,
                                         at(model.worst_error_at), model.tests),
                             model.worst_error <= allowed));
  }
  return rows;
}

/// The kind of thing that a check is about: "element" of "element front left"; empty without a name.
std::string kind_of(const std::string& subject) {
  const std::size_t end = subject.find(' ');
  return end == std::string::npos ? "" : subject.substr(0, end);
}

/// "element front left, front right", or "all 6 elements" if there are no others of their kind.
std::string subjects_words(const std::vector<std::string>& subjects, const std::set<std::string>& all) {
  const std::string kind = kind_of(subjects.front());
  const auto is_of_kind = [&](const std::string& subject) { return !kind.empty() && kind_of(subject) == kind; };
  if (subjects.size() > 1 && std::ranges::all_of(subjects, is_of_kind)) {
    const bool is_all = std::ranges::count_if(all, is_of_kind) == std::ssize(subjects);
    if (is_all) return "all " + count_words(subjects.size(), kind);
  }
  std::string words = subjects.front();
  for (std::size_t i = 1; i < subjects.size(); ++i)
    words += ", " + (is_of_kind(subjects[i]) ? subjects[i].substr(kind.size() + 1) : subjects[i]);
  return words;
}

/// Checks with the same outcome in one line, with all their subjects.
std::vector<study::CheckLine> joined_checks(const std::vector<study::CheckLine>& checks) {
  std::vector<study::CheckLine> joined;
  std::vector<std::vector<std::string>> subjects;
  std::set<std::string> all;
  for (const study::CheckLine& line : checks) {
    all.insert(line.subject);
    const auto same = std::ranges::find_if(joined, [&](const study::CheckLine& other) {
      return other.what == line.what && other.value == line.value && other.passed == line.passed;
    });
    if (same == joined.end()) {
      joined.push_back(line);
      subjects.push_back({line.subject});
    } else {
      subjects[static_cast<std::size_t>(same - joined.begin())].push_back(line.subject);
    }
  }
  for (std::size_t i = 0; i < joined.size(); ++i) joined[i].subject = subjects_words(subjects[i], all);
  return joined;
}

}  // namespace

std::string checks_table(const ShownCase& shown) {
  std::vector<Row> rows;
  for (const study::CheckLine& line : joined_checks(shown.checks))
    rows.push_back(check_row(line.subject, line.what, line.value, line.passed));
  if (shown.results.response)
    for (Row& row : solution_rows(*shown.results.response, shown.variant.display)) rows.push_back(std::move(row));
  const std::size_t failed = shown.failed_checks().size();
  return paragraph(failed ? fmt::format("✗ {} failed.", failed) : "✓ All passed.", failed ? "bad" : "good") +
      html_table({{"subject"}, {"check"}, {"value"}, {"verdict"}}, rows);
}

namespace {

/// A text that one or more cases share, and its place in the input file.
struct Notice {
  std::string text, place;
  std::set<std::size_t> cases;
};

void add(std::vector<Notice>& notices, const std::string& text, const std::string& place, std::size_t which) {
  auto found = std::ranges::find(notices, text, &Notice::text);
  if (found == notices.end()) found = notices.insert(found, {text, place, {}});
  found->cases.insert(which);
}

/// A warning without its place and without "warning:" and the name of its case, which are shown apart.
std::string warning_words(foundation::Problem problem, const std::string& case_name) {
  problem.origin = {};
  std::string text = foundation::message(problem);
  for (const std::string& part : {std::string("warning: "), "case \"" + case_name + "\": "})
    if (const std::size_t at = text.find(part); at != std::string::npos) text.erase(at, part.size());
  return text;
}

/// "(genset.toml:12; all cases)"
std::string where_words(const Notice& notice, const std::vector<ShownCase>& cases) {
  std::string owners;
  if (notice.cases.size() == cases.size()) owners = "all cases";
  else
    for (const std::size_t i : notice.cases) owners += (owners.empty() ? "" : ", ") + cases[i].name();
  if (cases.size() == 1) owners.clear();
  const std::string between = notice.place.empty() || owners.empty() ? "" : "; ";
  const std::string words = notice.place + between + owners;
  return words.empty() ? "" : "<span class=\"where\"> (" + escaped(words) + ")</span>";
}

std::string box(const std::string& style, const std::string& title, const std::vector<Notice>& notices,
                const std::vector<ShownCase>& cases) {
  if (notices.empty()) return "";
  std::string items;
  for (const Notice& n : notices) items += "<li>" + escaped(n.text) + where_words(n, cases) + "</li>\n";
  return fmt::format("<div class=\"{}\" role=\"note\"><h2>{}</h2><ul>{}</ul></div>\n", style, title, items);
}

/// The yield of the designs within tolerances. That the design of the file meets everything is no word on the others:
/// amber if any of them violates a requirement, or more than wanted.
std::string sample_box(const std::vector<ShownCase>& cases) {
  std::string words;
  const char* doubt = nullptr;
  for (const ShownCase& shown : cases) {
    if (!shown.results.sample) continue;
    const study::Sample& sample = *shown.results.sample;
    if (sample.request.yield && sample.yield_verdict() != study::YieldVerdict::met)
      doubt = "⚠ The designs within tolerances do not show the wanted yield";
    else if (!sample.request.yield && sample.any_violates())
      doubt = "⚠ Not all designs within tolerances meet the requirements";
    for (const std::string& sentence : results::sample_sentences(sample)) words += paragraph(sentence);
  }
  if (words.empty()) return "";
  return fmt::format("<div class=\"{}\" role=\"note\"><h2>{}</h2>{}</div>\n", doubt ? "alert" : "note",
                     doubt ? doubt : "Within tolerances", words);
}

}  // namespace

std::string page_notices(const std::vector<ShownCase>& cases, bool linked) {
  std::vector<Notice> warnings, failed, rigid, notes;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const foundation::Problem& problem : cases[i].warnings())
      add(warnings, warning_words(problem, cases[i].results.case_name), foundation::place(problem.origin), i);
    for (const std::string& text : cases[i].failed_checks()) add(failed, text, "", i);
    for (const std::string& text : cases[i].results.free_motions) add(rigid, text, "", i);
    for (const std::string& text : cases[i].results.notes) add(notes, text, "", i);
  }
  std::string html = judgement_box(cases, linked) + sample_box(cases) +
      box("alert", "⚠ " + count_words(warnings.size(), "warning"), warnings, cases) +
      box("alert", "✗ " + count_words(failed.size(), "failed check"), failed, cases) +
      box("note", "Rigid-body modes", rigid, cases) + box("note", "Notes", notes, cases);
  if (!cases.empty() && warnings.empty() && failed.empty())
    html += paragraph(
        "No warnings; all checks of the data passed" + std::string(cases.size() > 1 ? " in all cases." : "."), "quiet");
  return html;
}

namespace {

/// Verdict on a case from its own map, or else from the first map of the report.
const study::MapMark* map_mark(const ShownCase& shown, const std::vector<ShownCase>& cases) {
  const auto with_map = std::find_if(cases.begin(), cases.end(), [](const ShownCase& c) { return c.results.map; });
  const study::DesignMap* map = shown.results.map ? &*shown.results.map
      : with_map != cases.end()                   ? &*with_map->results.map
                                                  : nullptr;
  if (!map) return nullptr;
  const auto mark = std::ranges::find(map->marks, shown.results.case_name, &study::MapMark::name);
  return mark == map->marks.end() ? nullptr : &*mark;
}

Cell map_cell(const ShownCase& shown, const std::vector<ShownCase>& cases) {
  const study::MapMark* mark = map_mark(shown, cases);
  if (!mark) return {"–"};
  if (!mark->judged) return missing_verdict_cell("not computed");
  const std::string whose = shown.results.map && !shown.results.case_name.empty() ? " (own map)" : "";
  if (!mark->decides && !mark->judged->governing.feasible()) return {"violated, not binding" + whose};
  return verdict_cell(mark->judged->governing.feasible(), "met" + whose, "VIOLATED" + whose);
}

Cell requirements_cell(const study::CaseVerdict& judged) {
  const auto violated =
      std::ranges::count_if(judged.results, [](const study::RequirementResult& r) { return r.value && !r.met(); });
  if (violated == 0 && judged.not_judged() > 0)
    return missing_verdict_cell(fmt::format("{} not judged", judged.not_judged()));
  if (violated > 0 && !judged.decides) return {fmt::format("{} violated, not binding", violated)};
  return verdict_cell(violated == 0, "met", fmt::format("{} of {} VIOLATED", violated, judged.results.size()));
}

Cell motion_cell(const ShownCase& shown) {
  if (shown.grows()) return {"▲ unstable", false, Tone::bad};
  return {shown.results.free_motions.empty() ? "stable" : "rigid-body mode"};
}

/// Lowest and highest natural frequency above 0, or NaN.
std::pair<double, double> natural_range(const ShownCase& shown) {
  double lowest = std::numeric_limits<double>::quiet_NaN(), highest = lowest;
  if (!shown.variant.analyses.modes) return {lowest, highest};
  for (const modal::Mode& m : shown.results.modes.list) {
    if (m.angular_frequency.value_or(0) <= 0) continue;
    lowest = std::fmin(lowest, *m.angular_frequency);
    highest = std::fmax(highest, *m.angular_frequency);
  }
  return {lowest, highest};
}

}  // namespace

std::string glance_table(const std::vector<ShownCase>& cases) {
  const bool has_map = std::ranges::any_of(cases, [&](const ShownCase& c) { return map_mark(c, cases) != nullptr; });
  std::vector<Cell> headings = {{"case"}, right("changes"), {"warnings"}, {"checks"}, {"limits"}};
  const bool has_verdict = std::ranges::any_of(cases, [](const ShownCase& c) { return c.results.verdict.has_value(); });
  if (has_verdict) headings.push_back({"requirements"});
  if (has_map) headings.push_back({"rules of the map"});
  const project::DisplayUnits display = cases.empty() ? project::DisplayUnits() : cases.front().variant.display;
  headings.push_back({"motion"});
  for (const char* which : {"lowest mode", "highest mode"})
    headings.push_back(right(std::string(which) + " [" + results::frequency_unit(display) + "]"));
  std::vector<std::vector<Cell>> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const ShownCase& c = cases[i];
    const std::size_t warnings = c.warnings().size(), failed = c.failed_checks().size(), exceeded = c.exceeded_limits();
    std::vector<Cell> row = {
        html_cell(
            fmt::format("<button type=\"button\" class=\"link\" data-select=\"{}\">{}</button>", i, escaped(c.name()))),
        right(c.results.changes.empty() ? "–" : std::to_string(c.results.changes.size())),
        warnings ? Cell{fmt::format("⚠ {}", warnings), false, Tone::bad} : Cell{"none"},
        verdict_cell(!failed, "ok", fmt::format("{} FAILED", failed)),
        c.limits() ? verdict_cell(!exceeded, "met", fmt::format("{} of {} VIOLATED", exceeded, c.limits()))
                   : Cell{"–"}};
    if (has_verdict) row.push_back(c.results.verdict ? requirements_cell(*c.results.verdict) : Cell{"–"});
    if (has_map) row.push_back(map_cell(c, cases));
    row.push_back(motion_cell(c));
    const auto [lowest, highest] = natural_range(c);
    add_frequency(row, lowest, display);
    add_frequency(row, highest, display);
    rows.push_back(std::move(row));
  }
  return cases.empty() ? "" : html_table(headings, rows, "records");
}

std::string case_head(const ShownCase& shown, std::size_t cases) {
  std::string faults;
  const auto add_fault = [&](const std::string& words) { faults += (faults.empty() ? "" : ", ") + words; };
  if (const std::size_t count = shown.warnings().size()) add_fault(count_words(count, "warning"));
  if (const std::size_t count = shown.failed_checks().size()) add_fault(count_words(count, "failed check"));
  if (shown.grows()) add_fault("unstable motion");
  std::string changes;
  for (const std::string& text : shown.results.changes) changes += "<li><code>" + escaped(text) + "</code></li>";
  return fmt::format(
      "<section class=\"case-head\"><h2>{}{}</h2>\n{}{}</section>\n", cases > 1 ? "Case: " : "", escaped(shown.name()),
      faults.empty() ? "" : paragraph("⚠ Check the results: " + faults + "; see the top of the page.", "bad"),
      changes.empty() ? "" : "<p>Changes from the base model:</p><ul class=\"changes\">" + changes + "</ul>\n");
}

}  // namespace trivet::report
