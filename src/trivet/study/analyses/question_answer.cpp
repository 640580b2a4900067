// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/question_answer.h"

namespace trivet::study {

const std::vector<QuestionAnswer>& question_answers() {
#define TRIVET_ANSWER(name) project::named(#name, name##_answer),
  static const std::vector<QuestionAnswer> list = {TRIVET_QUESTIONS(TRIVET_ANSWER)};
#undef TRIVET_ANSWER
  return list;
}

}  // namespace trivet::study
