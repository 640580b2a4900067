// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/check_tables.h"
#include "trivet/report/drawing/in_documents.h"

#include <fmt/format.h>

#include "trivet/documents/html_table.h"

namespace trivet::report {
namespace {

Row check_row(const std::string& subject, const std::string& what, const std::string& value, bool passed) {
  return {{{subject}, {what}, {value}, verdict_cell(passed)}, passed ? "" : "failed"};
}

/// A value to know, without a verdict.
Row information_row(const std::string& what, const std::string& value) {
  return {{{"response"}, {what}, {value}, {}}, ""};
}

std::string undefined_words(const std::vector<double>& undefined_at) {
  std::string words;
  for (const double omega : undefined_at) words += fmt::format("{}{:.6g}", words.empty() ? "" : ", ", omega);
  return words.empty() ? "none" : words + " rad/s";
}

std::vector<Row> solution_rows(const study::ResponseAnswer& answer) {
  const response::SolutionCheck& check = answer.curves.check;
  const response::DeepCheck& deep = answer.deep;
  std::vector<Row> rows = {
      information_row(
          "worst backward error of the solution",
          fmt::format("{:.3g} at ω = {:.5g} rad/s", check.worst_backward_error, check.at_angular_frequency)),
      check_row("response",
                fmt::format("second solver agrees at {} {}", deep.frequencies,
                            deep.frequencies == 1 ? "frequency" : "frequencies"),
                fmt::format("worst difference {:.3g} at ω = {:.5g} rad/s, allowed {:.3g}", deep.worst_difference,
                            deep.at_angular_frequency, deep.allowed),
                deep.passed),
      information_row("frequencies that needed the pivoted solver", std::to_string(check.fallbacks)),
      information_row("frequencies at which the response is not defined", undefined_words(check.undefined_at))};
  if (answer.model) {
    constexpr double allowed = 1e-3;  // of a plot, see response::CurveModelOptions
    const response::CurveModel& model = *answer.model;
    rows.push_back(check_row(
        "response", "curves of this page compared with independent solves and extrema",
        fmt::format("drawn from {} {}; largest difference {:.2g} % at ω = {:.5g} rad/s, {} compared", model.solves,
                    model.solves == 1 ? "solve" : "solves", 100 * model.worst_error, model.worst_error_at, model.tests),
        model.worst_error <= allowed));
  }
  return rows;
}

}  // namespace

std::string checks_table(const ShownCase& shown) {
  std::vector<Row> rows;
  for (const study::CheckLine& line : shown.checks)
    rows.push_back(check_row(line.subject, line.what, line.value, line.passed));
  if (shown.answers.response)
    for (Row& row : solution_rows(*shown.answers.response)) rows.push_back(std::move(row));
  const std::size_t failed = shown.failed_checks().size();
  return paragraph(failed ? fmt::format("✗ {} failed.", failed) : "✓ All passed.", failed ? "bad" : "good") +
      html_table({{"subject"}, {"check"}, {"value"}, {"verdict"}}, rows);
}

}  // namespace trivet::report
