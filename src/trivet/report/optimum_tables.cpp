// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/report/answer_tables.h"
#include "trivet/report/html_table.h"
#include "trivet/report/result_tables.h"
#include "trivet/results/axis_words.h"
#include "trivet/results/optimization_results.h"
#include "trivet/study/design_front.h"
#include "trivet/study/optimization.h"

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
                     {p.idle           ? "changes nothing here"
                          : p.at_bound ? "at the end of its range"
                                       : ""}},
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

std::string optimum_conditions_table(const Optimization& found) {
  std::vector<Row> rows;
  for (const study::ActiveRequirement& one : found.active)
    rows.push_back({{{words_in_case(found, one.result_case, one.words)},
                     one.minimized ? Cell{} : right(fmt::format("{:.3g} %", one.multiplier))},
                    ""});
  for (const study::Conflict& one : found.conflicts)
    rows.push_back({{{words_in_case(found, one.result_case, one.words) + " contradicts the others"},
                     right(fmt::format("to be eased {:.4g} times", one.factor))},
                    "failed"});
  if (rows.empty()) return "";
  return html_table({{"What holds the optimum"}, right("1 % more of its bound brings")}, rows);
}

}  // namespace

std::string optimum_tables(const study::Answers& answers) {
  if (!answers.optimization) return "";
  const Optimization& found = *answers.optimization;
  std::string text = found.feasible ? "Every requirement is met at the optimum. " : "NOT every requirement is met. ";
  text +=
      fmt::format("{} of {} starts reached it; {} designs computed", found.agreeing, found.starts, found.evaluations);
  if (found.no_slopes.empty() && !found.active.empty())
    text += fmt::format("; residual of the optimality conditions {:.2g}", found.residual);
  text += ". A search finds the best of where it looked; it proves no global optimum.";
  return optimum_parameters_table(found) + optimum_amplitudes_table(found) + optimum_requirements_table(found) +
      optimum_conditions_table(found) + hint(text);
}

std::string front_tables(const study::Answers& answers) {
  if (!answers.front) return "";
  const study::DesignFront& front = *answers.front;
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
