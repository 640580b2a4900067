// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/documents/screen.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/case_results.h"

/// Results as JSON and CSV (docs/json.md) and as text, by the name of their analysis in [analyses]; their table is in
/// result_writers.cpp. Each requires that the result exists.
namespace trivet::results {

[[nodiscard]] std::string result_json(const std::string& analysis, const project::Case& variant,
                                      const study::CaseResults& results);
[[nodiscard]] std::string result_csv(const std::string& analysis, const project::Case& variant,
                                     const study::CaseResults& results);
[[nodiscard]] std::string result_text(const std::string& analysis, const project::Case& variant,
                                      const study::CaseResults& results);

/// All of it, described once; a view of `results`.
[[nodiscard]] Document result_document(const std::string& analysis, const project::Case& variant,
                                       const study::CaseResults& results);

/// Its tables and sentences for the page; empty if the case has no such result. Only for results with a document.
[[nodiscard]] std::string result_html(const std::string& analysis, const project::Case& variant,
                                      const study::CaseResults& results);

/// A table in a result folder.
struct ResultTable {
  const char* file;  ///< "random.csv"
  std::function<std::string(const project::Case& variant, const study::CaseResults& results)> csv;
  bool (*is_in)(const study::CaseResults& results) = nullptr;  ///< nullptr: every result has it
};
/// The tables of a result; `result_csv` is the first one.
[[nodiscard]] const std::vector<ResultTable>& result_tables(const std::string& analysis);

/// The numbers of a result, as views of `results`, which must outlive them.
[[nodiscard]] LabelledArrays result_arrays(const std::string& analysis, const project::Case& variant,
                                           const study::CaseResults& results);

struct ResultFile {
  std::string name;  ///< "random.csv"
  std::string content;
};
/// All tables of a case for its result folder.
[[nodiscard]] std::vector<ResultFile> result_files(const project::Case& variant, const study::CaseResults& results);

/// All results of a case for the screen.
[[nodiscard]] std::string results_summary(const project::Case& variant, const study::CaseResults& results,
                                          std::size_t width = documents::width_in_files);

/// The limits on the response for the page; empty without limits.
[[nodiscard]] std::string limits_html(const study::CaseResults& results);

}  // namespace trivet::results
