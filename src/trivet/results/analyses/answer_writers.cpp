// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/message_list.h"
#include "trivet/results/design/front_results.h"
#include "trivet/results/design/map_json.h"
#include "trivet/results/design/map_text.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/format/answer_writer.h"
#include "trivet/results/format/written_answers.h"

namespace trivet::results {
namespace json {

Json warnings(const foundation::Problems& problems) {
  Json result = Json::array();
  foundation::Problems warnings;
  for (const auto& problem : problems.list())
    if (problem.severity == foundation::Severity::warning) warnings.add(problem);
  const foundation::Problems first = foundation::listed(warnings);
  for (const auto& problem : first.list()) result.push_back(foundation::message(problem));
  if (const std::string rest = foundation::rest_of_list(warnings); !rest.empty()) result.push_back(rest);
  return result;
}

Json curve(const response::Curve& c) { return {{"name", c.name}, {"unit", c.unit}, {"complex", list(c.value)}}; }

Json curves(const std::vector<response::Curve>& list) {
  Json result = Json::array();
  for (const response::Curve& one : list) result.push_back(curve(one));
  return result;
}

}  // namespace json

namespace {

/// The map as one of the answers of a run; the command `map` writes it with its own options.
const AnswerWriter map_results = {
    .has_answer = [](const project::Case&,
                     const study::Answers& answers) { return answers.map || !answers.map_pairs.empty(); },
    .json = [](const project::Case&, const study::Answers& answers) -> json::Json {
      if (answers.map) return json::design_map(*answers.map);
      json::Json pairs = json::Json::array();
      for (const study::DesignMap& map : answers.map_pairs) pairs.push_back(json::design_map(map));
      return {{"pairs", pairs}};
    },
    .tables = {{"map.csv",
                [](const project::Case&, const study::Answers& answers) {
                  return answers.map ? map_csv(*answers.map) : map_pairs_csv(answers.map_pairs);
                }}},
    .text =
        [](const project::Case&, const study::Answers& answers) {
          return answers.map ? map_text(*answers.map) : map_pairs_text(answers.map_pairs);
        },
    .arrays =
        [](const project::Case&, const study::Answers& answers, LabelledArrays& list) {
          if (answers.map) add_map_arrays(*answers.map, "", list);
          for (std::size_t k = 0; k < answers.map_pairs.size(); ++k)
            add_map_arrays(answers.map_pairs[k], fmt::format("pair{}.", k + 1), list);
        },
};

/// The best design, or the front, as one of the answers of a run; the command `optimize` writes it alone.
const AnswerWriter optimize_results = {
    .has_answer = [](const project::Case&,
                     const study::Answers& answers) { return answers.optimization || answers.front; },
    .json =
        [](const project::Case&, const study::Answers& answers) {
          return answers.front ? json::front(*answers.front) : json::optimization(*answers.optimization);
        },
    .tables = {{"optimum.csv",
                [](const project::Case&, const study::Answers& answers) {
                  return answers.front ? front_csv(*answers.front) : optimization_csv(*answers.optimization);
                }}},
    .text =
        [](const project::Case&, const study::Answers& answers) {
          return answers.front ? front_text(*answers.front) : optimization_text(*answers.optimization);
        },
    .arrays =
        [](const project::Case&, const study::Answers& answers, LabelledArrays& list) {
          if (answers.front) add_front_arrays(*answers.front, list);
          else add_optimization_arrays(*answers.optimization, list);
        },
};

}  // namespace

namespace {

std::vector<AnswerWriter> with_tables(std::vector<AnswerWriter> list) {
  for (AnswerWriter& writer : list)
    for (const char* file : writer.files)
      writer.tables.push_back(
          {file, [document = writer.document, file](const project::Case& variant, const study::Answers& answers) {
             return as_csv(document(variant, answers), file);
           }});
  return list;
}

}  // namespace

const std::vector<AnswerWriter>& answer_writers() {
#define TRIVET_WRITER(name) project::named(#name, name##_results),
  static const std::vector<AnswerWriter> list = with_tables(
      {TRIVET_WRITER(modes) TRIVET_WRITER(roots) TRIVET_WRITER(response) TRIVET_WRITER(peaks) TRIVET_WRITER(static)
           TRIVET_QUESTIONS(TRIVET_WRITER) TRIVET_WRITER(limit_lines) TRIVET_WRITER(measurements) TRIVET_WRITER(map)
               TRIVET_WRITER(optimize) TRIVET_WRITER(load_sharing)});
#undef TRIVET_WRITER
  return list;
}

json::Json written_json(const AnswerWriter& writer, const project::Case& variant, const study::Answers& answers) {
  return writer.document ? as_json(writer.document(variant, answers)) : writer.json(variant, answers);
}

std::string written_text(const AnswerWriter& writer, const project::Case& variant, const study::Answers& answers,
                         Form form) {
  if (writer.document) return as_text(writer.document(variant, answers), variant.display, form);
  return (form == in_summary && writer.summary ? writer.summary : writer.text)(variant, answers);
}

Single warnings_part(const study::Answers& answers) {
  return {.name = "warnings", .value = json::warnings(answers.warnings)};
}

Sentence excited_part(const project::Case& variant, const std::string& question) {
  const std::string line = excited_at_once(variant, question);
  return {.parts = {line.substr(0, line.find('\n'))}, .forms = on_screen | on_page};
}

namespace {

const AnswerWriter& writer_of(const std::string& question) {
  const auto& list = answer_writers();
  const auto found = std::ranges::find(list, question, &AnswerWriter::name);
  if (found == list.end()) throw foundation::InvalidInput("no answer is called \"" + question + "\"");
  return *found;
}

}  // namespace

std::string answer_json(const std::string& question, const project::Case& variant, const study::Answers& answers) {
  return json::text(written_json(writer_of(question), variant, answers), 1) + "\n";
}

std::string answer_csv(const std::string& question, const project::Case& variant, const study::Answers& answers) {
  return writer_of(question).tables.front().csv(variant, answers);
}

std::string answer_text(const std::string& question, const project::Case& variant, const study::Answers& answers) {
  return written_text(writer_of(question), variant, answers, on_screen);
}

std::string answer_html(const std::string& question, const project::Case& variant, const study::Answers& answers) {
  const AnswerWriter& writer = writer_of(question);
  return writer.is_there(variant, answers) ? as_html(writer.document(variant, answers), variant.display) : "";
}

const std::vector<AnswerTable>& answer_tables(const std::string& question) { return writer_of(question).tables; }

LabelledArrays answer_arrays(const std::string& question, const project::Case& variant, const study::Answers& answers) {
  LabelledArrays list;
  const AnswerWriter& writer = writer_of(question);
  if (writer.document) add_arrays(writer.document(variant, answers), list);
  else writer.arrays(variant, answers, list);
  return list;
}

std::vector<AnswerFile> answer_files(const project::Case& variant, const study::Answers& answers) {
  std::vector<AnswerFile> files;
  for (const AnswerWriter& writer : answer_writers())
    if (writer.is_there(variant, answers))
      for (const AnswerTable& table : writer.tables) files.push_back({table.file, table.csv(variant, answers)});
  return files;
}

std::string answers_summary(const project::Case& variant, const study::Answers& answers) {
  std::string text;
  for (const AnswerWriter& writer : answer_writers()) {
    if (!writer.is_there(variant, answers)) continue;
    const std::string one = written_text(writer, variant, answers, in_summary);
    if (!one.empty()) text += one + "\n";
  }
  return text;
}

}  // namespace trivet::results
