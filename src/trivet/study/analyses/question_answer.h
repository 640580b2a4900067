// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <any>
#include <memory>

#include "trivet/project/analyses/question_table.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

/// Computes the answer to one question of project/analyses/question_table.h. Each is defined in NAME_answer.cpp.
struct QuestionAnswer {
  const char* name = nullptr;  ///< set by question_answers()
  const char* about;           ///< one line of help for its command
  const char* to_add;          ///< what the file must specify; nullptr: the defaults suffice
  std::shared_ptr<const project::Question> (*by_default)();
  /// @throws foundation::NotComputable, foundation::InvalidInput with the reason if there is no answer; warnings of the
  /// computation are added to the list
  std::any (*answer)(const CaseContext& context, const project::Question& asked, foundation::Problems& warnings);
};

namespace detail {

template <typename Asked, typename Answer, Answer (*answer)(const CaseContext&, const Asked&, foundation::Problems&)>
std::any answer_as_any(const CaseContext& context, const project::Question& asked, foundation::Problems& warnings) {
  return answer(context, dynamic_cast<const Asked&>(asked), warnings);
}

template <auto answer>
struct Signature;
template <typename Asked, typename Answer, Answer (*answer)(const CaseContext&, const Asked&, foundation::Problems&)>
struct Signature<answer> {
  static constexpr auto any = answer_as_any<Asked, Answer, answer>;
  static std::shared_ptr<const project::Question> by_default() { return std::make_shared<Asked>(); }
};

}  // namespace detail

/// A question answered by a function with its own types: Answer (const CaseContext&, const Asked&,
/// foundation::Problems& warnings).
template <auto answer>
[[nodiscard]] constexpr QuestionAnswer answered_by(const char* about, const char* to_add = nullptr) {
  return {nullptr, about, to_add, detail::Signature<answer>::by_default, detail::Signature<answer>::any};
}

#define TRIVET_ANSWER(name) extern const QuestionAnswer name##_answer;
TRIVET_QUESTIONS(TRIVET_ANSWER)
#undef TRIVET_ANSWER

/// All of them with their names, in the order of the table.
[[nodiscard]] const std::vector<QuestionAnswer>& question_answers();

}  // namespace trivet::study
