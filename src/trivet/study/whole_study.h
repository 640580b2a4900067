// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trivet/study/answers.h"

namespace trivet::study {

/// Everything that a project asks, in all its cases; maps of the base model and of cases that ask another one.
/// @param progress  "CASE: task" and the share of the whole
/// @param done  takes each case when it is answered
[[nodiscard]] std::vector<Answers> run(const project::Project& project, const foundation::Progress& progress = {},
                                       const std::function<void(std::size_t index, const Answers&)>& done = {});

/// One check that the data passed or failed, in words.
struct CheckLine {
  std::string subject;
  std::string what;
  std::string value;
  bool passed = true;
  bool operator==(const CheckLine&) const = default;
};

/// Checks of every body and element of a case, with their figures.
[[nodiscard]] std::vector<CheckLine> check_lines(const project::Case& variant);

/// What can be said of a case without answering its questions.
struct CaseCheck {
  std::string case_name;
  foundation::Problems warnings;  ///< of the data, the modes and the roots
  std::vector<CheckLine> lines;   ///< of a case other than the base model: those that differ from it
  std::vector<std::string> free_motions;
  std::vector<std::string> notes;           ///< of the base model: bodies that gravity tilts
  std::optional<response::DeepCheck> deep;  ///< two solvers compared, if that was asked for
};

/// All cases of a project. @param deep  compare the solver with a second, independent one
[[nodiscard]] std::vector<CaseCheck> check(const project::Project& project, bool deep = false);

}  // namespace trivet::study
