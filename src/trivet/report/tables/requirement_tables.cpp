// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/html_table.h"
#include "trivet/report/tables/result_tables.h"
#include "trivet/results/design/verdict_words.h"

namespace trivet::report {

Cell requirement_cell(const study::RequirementResult& result) {
  const std::string word = results::verdict_word(result);
  return result.value ? verdict_cell(result.met(), word, word) : missing_verdict_cell(word);
}

const char* requirement_style(const study::RequirementResult& result) {
  return !result.value ? "unjudged" : result.met() ? "" : "failed";
}

std::string requirements_table(const study::CaseResults& results) {
  if (!results.verdict) return "";
  std::vector<Row> rows;
  for (const results::RequirementRow& row : results::requirement_rows(*results.verdict))
    rows.push_back({{{row.words}, right(row.value), {row.place}, right(row.margin), requirement_cell(*row.result)},
                    requirement_style(*row.result)});
  std::string html = paragraph(results::verdict_summary(*results.verdict));
  html += html_table({{"requirement"}, right("value"), {"at"}, right("margin"), {"verdict"}}, rows);
  for (const std::string& reason : results::reasons_words(*results.verdict)) html += hint("Not judged: " + reason);
  return html + hint("Margin: limit over value, or value over limit where more is better; 1 on the limit.");
}

std::string envelope_table(const study::Envelope& envelope) {
  if (envelope.rows.empty()) return "";
  std::vector<Row> rows;
  const results::LargestOfKind largest = results::largest_of(envelope);
  for (const study::EnvelopeRow& row : envelope.rows)
    rows.push_back(
        {{{row.name},
          quantity_cell(largest.shown(row.unit, row.least), results::display_unit(envelope.display, row.unit)),
          {results::case_of_envelope(row.least_in)},
          quantity_cell(largest.shown(row.unit, row.largest), results::display_unit(envelope.display, row.unit)),
          {results::case_of_envelope(row.largest_in)}},
         ""});
  std::string html = html_table({{"at rest"}, right("least"), {"in"}, right("largest"), {"in"}}, rows);
  for (const auto& [name, reason] : envelope.left_out)
    html += hint("Without " + results::case_of_envelope(name) + ": " + reason);
  return html +
      hint("Every case under its own gravity and constant forces. Compression of a mount is along its axis; "
           "the gap left is after the largest dynamic motion.");
}

}  // namespace trivet::report
