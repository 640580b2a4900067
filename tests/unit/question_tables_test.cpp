// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "trivet/results/answer_writer.h"
#include "trivet/study/asked_questions.h"

namespace {

using namespace trivet;

TEST(QuestionTables, WriteEveryAnswerThatCanBeAskedFor) {
  std::vector<std::string> written;
  for (const results::AnswerWriter* writer : results::answer_writers()) {
    written.emplace_back(writer->name);
    EXPECT_FALSE(writer->tables.empty()) << writer->name << " has no table for --csv";
  }
  for (const study::AskedQuestion& question : study::asked_questions()) {
    EXPECT_THAT(written, testing::Contains(question.name));
    EXPECT_EQ(&study::asked_question(question.name), &question);
  }
  EXPECT_ANY_THROW(static_cast<void>(study::asked_question("weather")));
}

}  // namespace
