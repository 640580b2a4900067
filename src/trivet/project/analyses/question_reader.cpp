// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/question_reader.h"

#include <utility>

namespace trivet::project {
namespace {

/// An excitation that a question needs, in words.
struct Needed {
  const std::vector<std::string>& names;
  const char* kind;
  const char* remedy;
};

Needed needed(Drive drive, const Mentioned& mentioned) {
  switch (drive) {
    case Drive::random: return {mentioned.random_excitations, "random", "add [excitations.NAME] with type = \"random\""};
    case Drive::time: return {mentioned.time_excitations, "time", "add [excitations.NAME] with type = \"time\""};
    case Drive::orders: return {mentioned.order_excitations, "order", "add [excitations.NAME] with type = \"orders\" or \"unbalance\""};
    case Drive::harmonic: case Drive::none: break;
  }
  return {mentioned.harmonic_excitations, "harmonic", "add [excitations.NAME] with type = \"harmonic\", \"unbalance\" or \"base\""};
}

}  // namespace

const std::vector<QuestionReader>& question_readers() {
#define TRIVET_READER(name) named(#name, name##_question),
  static const std::vector<QuestionReader> list = {TRIVET_QUESTIONS(TRIVET_READER)};
#undef TRIVET_READER
  return list;
}

void read_questions(TableReader& analyses, const ResultNames& names, const Mentioned& mentioned, Analyses& result) {
  for (const QuestionReader& question : question_readers()) {
    const Node* table = analyses.table(question.name);
    if (!table) continue;
    const Needed excitation = needed(question.drive, mentioned);
    const bool driven = question.drive == Drive::none || (question.moves_by_itself && question.moves_by_itself(*table));
    if (!driven && excitation.names.empty())
      analyses.error(question.name, std::string("no ") + excitation.kind + " excitation in the model", "this answer needs one", excitation.remedy);
    TableReader reader(*table, std::string("analyses.") + question.name, analyses.problems());
    result.questions[question.name] = question.read(reader, names, mentioned);
    reader.finish();
  }
}

void check_questions(const model::System& system, const Analyses& asked, foundation::Problems& problems) {
  for (const QuestionReader& reader : question_readers())
    if (const Question* question = asked.find<Question>(reader.name); question && reader.check) reader.check(*question, system, problems);
}

}  // namespace trivet::project
