// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/html_table.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/tables/analysis_tables.h"
#include "trivet/report/tables/result_tables.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/study/optimize/design_front.h"
#include "trivet/study/optimize/optimization.h"

namespace trivet::report {
namespace {

using study::Optimization;

std::string words_in_case(const Optimization& found, std::size_t c, const std::string& words) {
  const std::string& name = found.after[c].case_name;
  return name.empty() ? words : "case " + name + ": " + words;
}

Cell optimum_margin_cell(const study::RequirementResult& result) {
  return result.value ? aligned_cell(result.margin) : missing_verdict_cell("not judged");
}

std::string optimum_parameters_table(const Optimization& found) {
  std::vector<Row> rows;
  for (const study::OptimizedParameter& p : found.parameters) {
    const std::string unit = results::axis_unit(p.axis);
    rows.push_back({{{p.axis.name},
                     {unit},
                     number_cell(p.axis.from),
                     number_cell(p.axis.to),
                     p.given ? number_cell(*p.given) : right("differ"),
                     number_cell(p.best, 6),
                     right(results::step_words(p.below, found)),
                     right(results::step_words(p.above, found)),
                     {results::parameter_remark(p)}},
                    ""});
  }
  const std::string what = found.minimizes ? "minimised" : "margin";
  return html_table({{"Parameter"},
                     {"unit"},
                     right("from"),
                     right("to"),
                     right("given"),
                     right("optimum"),
                     right(what + ": 1 % of range less"),
                     right("1 % more"),
                     {""}},
                    rows);
}

std::string optimum_amplitudes_table(const Optimization& found) {
  std::vector<Row> rows;
  for (const study::MinimizedAmplitude& one : found.minimized)
    rows.push_back({{{words_in_case(found, one.result_case, one.name)},
                     quantity_cell(one.before, one.unit),
                     quantity_cell(one.after, one.unit),
                     one.limit ? quantity_cell(*one.limit, one.unit) : Cell{}},
                    ""});
  if (rows.empty()) return "";
  return html_table({{"Minimised"}, right("given"), right("optimum"), right("limit")}, rows);
}

std::string optimum_requirements_table(const Optimization& found) {
  std::vector<Row> rows;
  for (std::size_t c = 0; c < found.after.size(); ++c)
    for (std::size_t r = 0; r < found.after[c].results.size(); ++r) {
      const study::RequirementResult& after = found.after[c].results[r];
      rows.push_back({{{words_in_case(found, c, after.words)},
                       optimum_margin_cell(found.before[c].results[r]),
                       optimum_margin_cell(after),
                       requirement_cell(after)},
                      requirement_style(after)});
    }
  if (rows.empty()) return "";
  return html_table({{"Requirement"}, right("margin, given"), right("margin, optimum"), {"verdict"}}, rows);
}

/// Natural frequencies and decoupling of the given design and of the optimum.
std::string optimum_frequencies_table(const Optimization& found, const project::DisplayUnits& display) {
  constexpr std::size_t most_modes = 12, most_bodies = 12;
  std::vector<Row> frequencies, decoupling;
  for (std::size_t c = 0; c < found.after.size(); ++c) {
    const study::DesignSummary &before = found.summaries_before[c], &after = found.summaries_after[c];
    const std::vector<double>&given = before.angular_frequencies, &best = after.angular_frequencies;
    for (std::size_t i = 0; i < std::min(std::max(given.size(), best.size()), most_modes); ++i)
      frequencies.push_back({{{words_in_case(found, c, fmt::format("mode {}", i + 1))},
                              i < given.size() ? frequency_cell(given[i], display) : right("–"),
                              i < best.size() ? frequency_cell(best[i], display) : right("–")},
                             ""});
    for (std::size_t b = 0; b < std::min(after.decoupling.size(), most_bodies); ++b) {
      const auto same = std::ranges::find_if(before.decoupling,
                                             [&](const auto& one) { return one.body == after.decoupling[b].body; });
      decoupling.push_back({{{words_in_case(found, c, after.decoupling[b].body)},
                             same == before.decoupling.end() ? right("not known") : percent_cell(same->least),
                             percent_cell(after.decoupling[b].least)},
                            ""});
    }
  }
  const std::string unit = results::frequency_unit(display);
  std::string html;
  if (!frequencies.empty())
    html += html_table({{"Natural frequency"}, right("given [" + unit + "]"), right("optimum [" + unit + "]")},
                       frequencies);
  if (!decoupling.empty())
    html += html_table({{"Decoupling, least of its modes"}, right("given"), right("optimum")}, decoupling);
  return html;
}

/// Why peaks are gone, if the search went on to a design without them.
std::string gone_peaks_table(const Optimization& found, const project::DisplayUnits& display) {
  if (found.gone_peaks.empty()) return "";
  std::vector<Row> rows;
  for (const study::GonePeak& one : found.gone_peaks)
    rows.push_back({{{words_in_case(found, one.result_case, one.name)},
                     number_cell(-one.measure),
                     frequency_cell(one.angular_frequency, display)},
                    ""});
  return hint("The search went on to the design furthest from a peak, by the fall of the curves.") +
      html_table({{"No peak of"}, right("gone by"), frequency_cell_heading("nearest to one at", display)}, rows);
}

std::string optimum_conflicts_table(const Optimization& found) {
  if (found.conflicts.empty()) return "";
  std::vector<Row> rows;
  for (const study::Conflict& one : found.conflicts)
    rows.push_back({{{words_in_case(found, one.result_case, one.words)},
                     right(std::isinf(one.factor) ? "∞" : fmt::format("{:.4g}", one.factor)),
                     right(std::isinf(one.without) ? "∞" : fmt::format("{:.4g}", one.without))},
                    "failed"});
  return html_table(
      {{found.conflicts.size() == 1 ? "Cannot be met within the ranges" : "Contradict each other within the ranges"},
       right("met if its bound is eased by the factor"),
       right("least margin of the others without it")},
      rows);
}

std::string optimum_conditions(const Optimization& found, const project::DisplayUnits& display) {
  if (!found.no_slopes.empty())
    return hint("What holds the optimum is not known: there are no slopes next to it (" + found.no_slopes + ").");
  if (found.active.empty())
    return hint("Nothing holds the optimum: no requirement limits it.") + gone_peaks_table(found, display);
  std::vector<Row> rows;
  for (const study::ActiveRequirement& one : found.active)
    rows.push_back({{{words_in_case(found, one.result_case, one.words)},
                     one.minimized ? Cell{} : right(fmt::format("{:.3g} %", one.multiplier))},
                    ""});
  return html_table({{"What holds the optimum"}, right("1 % more of its bound brings")}, rows) +
      hint(fmt::format("Residual of the optimality conditions: {:.2g} of the largest slope.", found.residual)) +
      optimum_conflicts_table(found);
}

/// Lines of a text as remarks.
std::string remarks(const std::string& text) {
  std::string html;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) html += hint(text.substr(at, end - at));
    at = end + 1;
  }
  return html;
}

}  // namespace

std::string optimum_tables(const study::CaseResults& results) {
  if (!results.optimization) return "";
  const Optimization& found = *results.optimization;
  return paragraph(results::optimization_headline(found) + ".") + remarks(results::optimization_mounts(found)) +
      optimum_parameters_table(found) + optimum_amplitudes_table(found) + optimum_requirements_table(found) +
      optimum_frequencies_table(found, results.display) + optimum_conditions(found, results.display) +
      remarks(results::optimization_search(found));
}

std::string front_tables(const study::CaseResults& results) {
  if (!results.front) return "";
  const study::DesignFront& front = *results.front;
  std::vector<Cell> headings = {right("point")};
  for (const study::FrontObjective& one : front.objectives) headings.push_back(right(one.name));
  for (const project::DesignAxis& axis : front.parameters) headings.push_back(right(results::axis_name(axis)));
  headings.push_back(right("residual"));
  headings.push_back({""});
  std::vector<Row> rows;
  for (std::size_t k = 0; k < front.points.size(); ++k) {
    Row row{{right(std::to_string(k + 1))}, ""};
    for (std::size_t i = 0; i < front.objectives.size(); ++i)
      row.cells.push_back(aligned_quantity_cell(front.points[k].amplitudes[i],
                                                results::DisplayUnit{front.objectives[i].unit, "", 1, true}));
    for (const double value : front.points[k].values) row.cells.push_back(aligned_cell(value));
    row.cells.push_back(right(fmt::format("{:.1g}", front.points[k].residual)));
    row.cells.push_back({front.knee == k ? "knee" : ""});
    rows.push_back(std::move(row));
  }
  const std::size_t left_out = front.dominated + front.coinciding + front.not_found;
  std::string text = "Less of one result is more of another. ";
  if (left_out > 0)
    text += fmt::format(
        "{} points left out: {} dominated, {} the same as others, {} without a design that meets the "
        "requirements. ",
        left_out, front.dominated, front.coinciding, front.not_found);
  return html_table(headings, rows) + hint(text + fmt::format("{} designs computed.", front.evaluations));
}

}  // namespace trivet::report
