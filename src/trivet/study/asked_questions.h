// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trivet/project/project.h"

namespace trivet::study {

/// A question that can be asked of a case by itself, as a command does.
struct AskedQuestion {
  const char* name;                   ///< of its table in [analyses]; `limit_lines` of its own
  const char* about;                  ///< one line of help
  std::vector<std::string> looks_at;  ///< tables of the file whose errors stop it
  /// What is asked: the file's own question, else one with everything at its default. @throws foundation::InvalidInput
  /// if the file must say more, with what to add
  std::function<project::Analyses(const project::Case& variant)> asked;
};

[[nodiscard]] const std::vector<AskedQuestion>& asked_questions();

/// By its name, which must be that of one of them.
[[nodiscard]] const AskedQuestion& asked_question(const std::string& name);

}  // namespace trivet::study
