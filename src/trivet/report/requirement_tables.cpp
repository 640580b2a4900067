// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/html_table.h"
#include "trivet/report/result_tables.h"
#include "trivet/results/verdict_words.h"

namespace trivet::report {

std::string requirements_table(const study::Answers& answers) {
  if (!answers.verdict) return "";
  std::vector<Row> rows;
  for (const results::RequirementRow& row : results::requirement_rows(*answers.verdict))
    rows.push_back({{{row.words},
                     right(row.value),
                     {row.place},
                     right(row.margin),
                     verdict_cell(row.met, row.verdict, row.verdict)},
                    row.met ? "" : "failed"});
  std::string html = paragraph(results::verdict_summary(*answers.verdict));
  html += html_table({{"requirement"}, right("value"), {"at"}, right("margin"), {"verdict"}}, rows);
  for (const std::string& reason : results::reasons_words(*answers.verdict)) html += hint("Not judged: " + reason);
  return html + hint("Margin: limit over value, or value over limit where more is better; 1 on the limit.");
}

}  // namespace trivet::report
