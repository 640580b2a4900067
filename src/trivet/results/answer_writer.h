// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/results/json_parts.h"
#include "trivet/results/written_answers.h"
#include "trivet/study/answers.h"

namespace trivet::results {

/// A table of a result folder: "random.csv".
struct CsvWriter {
  const char* file;
  std::string (*csv)(const project::Case& variant, const study::Answers& answers);
};

/// How the answer to one question is written. One file per question (NAME_results.cpp) defines one of these; answer_writers.cpp lists them.
struct AnswerWriter {
  const char* name;   ///< of the question in [analyses], of its command, and its key in results.json
  bool (*is_there)(const project::Case& variant, const study::Answers& answers);
  json::Json (*json)(const project::Case& variant, const study::Answers& answers);
  std::vector<CsvWriter> tables = {};  ///< of the result folder; the first one is what --csv prints
  std::string (*text)(const project::Case& variant, const study::Answers& answers);     ///< for the screen
  std::string (*summary)(const project::Case& variant, const study::Answers& answers) = nullptr;  ///< where `run` says less than the command
};

/// Each in NAME_results.cpp.
extern const AnswerWriter modes_writer, roots_writer, response_writer, peaks_writer, static_writer, random_writer, transient_writer, orders_writer,
    transmissibility_writer, power_writer, shapes_writer, shock_spectrum_writer, earthquake_writer, limit_lines_writer, load_sharing_writer;

/// All of them, in the order of the result file.
[[nodiscard]] const std::vector<const AnswerWriter*>& answer_writers();

[[nodiscard]] inline double hertz(double omega) { return omega / foundation::two_pi; }
[[nodiscard]] inline std::string mode_words(const std::optional<int>& mode) { return mode ? std::to_string(*mode) : "–"; }

namespace json {
/// A curve with its complex values.
[[nodiscard]] Json curve(const response::Curve& c);
}  // namespace json

}  // namespace trivet::results
