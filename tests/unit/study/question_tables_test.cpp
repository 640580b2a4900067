// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "trivet/project/analyses/question_reader.h"
#include "trivet/results/format/answer_writer.h"
#include "trivet/study/analyses/asked_questions.h"
#include "trivet/study/analyses/question_answer.h"

namespace question_tables_test {

using namespace trivet;

TEST(QuestionTables, WriteTheAnswerToEveryQuestion) {
  std::vector<std::string> written;
  for (const results::AnswerWriter& writer : results::answer_writers()) {
    written.emplace_back(writer.name);
    EXPECT_FALSE(writer.tables.empty()) << writer.name << " has no table for --csv";
  }
  for (const study::AskedQuestion& question : study::asked_questions()) {
    EXPECT_THAT(written, testing::Contains(question.name));
    EXPECT_EQ(&study::asked_question(question.name), &question);
  }
  EXPECT_ANY_THROW(static_cast<void>(study::asked_question("weather")));
}

#define TRIVET_NAME(name) #name,
const std::vector<std::string> table = {TRIVET_QUESTIONS(TRIVET_NAME)};
#undef TRIVET_NAME

template <typename Rows>
std::vector<std::string> names(const Rows& rows) {
  std::vector<std::string> result;
  for (const auto& row : rows) result.emplace_back(row.name);
  return result;
}

TEST(QuestionTables, ReadAnswerAndWriteEachQuestionUnderItsName) {
  EXPECT_EQ(names(project::question_readers()), table);
  EXPECT_EQ(names(study::question_answers()), table);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto& writers = results::answer_writers();
    EXPECT_TRUE(std::ranges::any_of(writers, [&](const results::AnswerWriter& writer) {
      return writer.name == table[i] && !writer.has_answer;
    })) << table[i];
    EXPECT_NE(study::question_answers()[i].by_default(), nullptr);
  }
}

}  // namespace question_tables_test
