// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/question_reader.h"

#include <utility>

#include "trivet/project/analyses/request_readers.h"

namespace trivet::project {
namespace {

const std::vector<std::string>& excitations_for(Drive drive, const NamesInFile& in_file) {
  switch (drive) {
    case Drive::random:
      return in_file.random_excitations;
    case Drive::time:
      return in_file.time_excitations;
    case Drive::orders:
      return in_file.order_excitations;
    case Drive::harmonic_or_orders:
      return in_file.harmonic_excitations.empty() ? in_file.order_excitations : in_file.harmonic_excitations;
    case Drive::harmonic:
    case Drive::none:
      break;
  }
  return in_file.harmonic_excitations;
}

}  // namespace

const std::vector<QuestionReader>& question_readers() {
#define TRIVET_READER(name) named(#name, name##_question),
  static const std::vector<QuestionReader> list = {TRIVET_QUESTIONS(TRIVET_READER)};
#undef TRIVET_READER
  return list;
}

void read_questions(TableReader& analyses, const ResultNames& names, const NamesInFile& in_file, Analyses& result) {
  for (const QuestionReader& question : question_readers()) {
    const Node* table = analyses.table(question.name);
    if (!table) continue;
    const bool driven = question.drive == Drive::none || (question.moves_by_itself && question.moves_by_itself(*table));
    if (!driven && excitations_for(question.drive, in_file).empty())
      analyses.error(question.name, missing_excitation(question.drive).finding, "this analysis needs one",
                     missing_excitation(question.drive).remedy);
    TableReader reader(*table, std::string("analyses.") + question.name, analyses.problems());
    result.questions[question.name] = question.read(reader, names, in_file);
    reader.finish();
  }
}

void check_questions(const model::System& system, const Analyses& asked,
                     const std::function<bool(const std::string&)>& answered, foundation::Problems& problems) {
  refuse_left_out_results(system, asked, problems);
  for (const QuestionReader& reader : question_readers())
    if (const Question* question = asked.find<Question>(reader.name); question && reader.check && answered(reader.name))
      reader.check(*question, system, problems);
}

}  // namespace trivet::project
