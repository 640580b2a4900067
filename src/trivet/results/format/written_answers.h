// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trivet/documents/labelled_arrays.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/answers.h"

/// Answers as JSON and CSV (docs/json.md) and as text, by the name of their question in [analyses]; their table is in
/// answer_writers.cpp. Each requires that the answer exists.
namespace trivet::results {

[[nodiscard]] std::string answer_json(const std::string& question, const project::Case& variant,
                                      const study::Answers& answers);
[[nodiscard]] std::string answer_csv(const std::string& question, const project::Case& variant,
                                     const study::Answers& answers);
[[nodiscard]] std::string answer_text(const std::string& question, const project::Case& variant,
                                      const study::Answers& answers);

/// Its tables and sentences for the page; empty if the case has no such answer. Only for answers with a document.
[[nodiscard]] std::string answer_html(const std::string& question, const project::Case& variant,
                                      const study::Answers& answers);

/// A table in a result folder.
struct AnswerTable {
  const char* file;  ///< "random.csv"
  std::function<std::string(const project::Case& variant, const study::Answers& answers)> csv;
};
/// The tables of an answer; `answer_csv` is the first one.
[[nodiscard]] const std::vector<AnswerTable>& answer_tables(const std::string& question);

/// The numbers of an answer, as views of `answers`, which must outlive them.
[[nodiscard]] LabelledArrays answer_arrays(const std::string& question, const project::Case& variant,
                                           const study::Answers& answers);

struct AnswerFile {
  std::string name;  ///< "random.csv"
  std::string content;
};
/// All tables of a case for its result folder.
[[nodiscard]] std::vector<AnswerFile> answer_files(const project::Case& variant, const study::Answers& answers);

/// All answers of a case for the screen.
[[nodiscard]] std::string answers_summary(const project::Case& variant, const study::Answers& answers);

/// Line with the excitations that act together in the answer to a question; empty if there is only one.
[[nodiscard]] std::string excited_at_once(const project::Case& variant, const std::string& question);
[[nodiscard]] std::string excited_at_once(const std::vector<std::string>& names);

/// The limits on the response for the page; empty without limits.
[[nodiscard]] std::string limits_html(const study::Answers& answers);

}  // namespace trivet::results
