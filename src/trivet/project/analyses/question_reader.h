// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "trivet/project/analyses/drive.h"
#include "trivet/project/analyses/question.h"
#include "trivet/project/analyses/question_table.h"
#include "trivet/project/analyses/selection_reader.h"

namespace trivet::project {

/// How one question is read. Each is defined in NAME_question.cpp.
struct QuestionReader {
  const char* name = nullptr;  ///< of its table in [analyses]; set by question_readers()
  Drive drive = Drive::none;   ///< the model must have an excitation of this kind
  std::unique_ptr<Question> (*read)(TableReader& reader, const ResultNames& names,
                                    const NamesInFile& in_file) = nullptr;
  bool searches_peaks = false;                           ///< its cost is that of a search for peaks
  bool of_large_systems = false;                         ///< measured up to `most_coordinates`
  double (*curves)(const Question& asked) = nullptr;     ///< number of curves, if not that of `selection.of`
  bool (*moves_by_itself)(const Node& table) = nullptr;  ///< true if it needs no excitation
  void (*check)(const Question& asked, const model::System& system,
                foundation::Problems& problems) = nullptr;  ///< checks the question against a valid model
  const char* keys = nullptr;                               ///< JSON Schema of its keys: `properties`, `required` …
};

#define TRIVET_READER(name) extern const QuestionReader name##_question;
TRIVET_QUESTIONS(TRIVET_READER)
#undef TRIVET_READER

/// All of them by their names, in the order of the table.
[[nodiscard]] const std::vector<QuestionReader>& question_readers();

/// Reads the questions of the file into `result`, and reports missing excitations.
void read_questions(TableReader& analyses, const ResultNames& names, const NamesInFile& in_file, Analyses& result);

/// Reports questions that do not suit the model.
/// @param answered  false for a question of which requirements only take the settings: one that has no answer is then
///                  not judged, with the reason, beside all others
void check_questions(const model::System& system, const Analyses& asked,
                     const std::function<bool(const std::string&)>& answered, foundation::Problems& problems);

}  // namespace trivet::project
