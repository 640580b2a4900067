// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/project/analyses/question_table.h"
#include "trivet/results/json_parts.h"
#include "trivet/results/written_answers.h"
#include "trivet/study/answers.h"

namespace trivet::results {

/// A table in a result folder: "random.csv".
struct CsvWriter {
  const char* file;
  std::string (*csv)(const project::Case& variant, const study::Answers& answers);
};

/// Writes the answer to one question. Each is defined in NAME_results.cpp.
struct AnswerWriter {
  const char* name = nullptr;  ///< name of the question in [analyses], of its command and of its key in results.json;
                               ///< set by answer_writers()
  /// nullptr: there is an answer if `of_questions` has one of this name, as for all questions of
  /// project/analyses/question_table.h.
  bool (*has_answer)(const project::Case& variant, const study::Answers& answers) = nullptr;
  json::Json (*json)(const project::Case& variant, const study::Answers& answers);
  std::vector<CsvWriter> tables = {};  ///< tables of the result folder; --csv prints the first one
  std::string (*text)(const project::Case& variant, const study::Answers& answers);  ///< for the screen
  std::string (*summary)(const project::Case& variant,
                         const study::Answers& answers) = nullptr;  ///< shorter text for `run`; nullptr: `text`

  [[nodiscard]] bool is_there(const project::Case& variant, const study::Answers& answers) const {
    return has_answer ? has_answer(variant, answers) : answers.of_questions.contains(name);
  }
};

extern const AnswerWriter modes_results, roots_results, response_results, peaks_results, static_results,
    limit_lines_results, load_sharing_results;
#define TRIVET_WRITER(name) extern const AnswerWriter name##_results;
TRIVET_QUESTIONS(TRIVET_WRITER)
#undef TRIVET_WRITER

/// All of them with their names, in the order of the result file.
[[nodiscard]] const std::vector<AnswerWriter>& answer_writers();

[[nodiscard]] inline double hertz(double omega) { return omega / foundation::two_pi; }
[[nodiscard]] inline std::string mode_words(const std::optional<int>& mode) {
  return mode ? std::to_string(*mode) : "–";
}

namespace json {
/// A curve with its complex values.
[[nodiscard]] Json curve(const response::Curve& c);
}  // namespace json

}  // namespace trivet::results
