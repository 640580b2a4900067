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

}  // namespace trivet::report
