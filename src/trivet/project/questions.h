// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/project/project.h"

/// The questions of a file, in addition to its model: keys of `analyses`, and `limits`, `limit_lines`.
namespace trivet::project {

/// Questions that must have no errors. An error in another question does not stop the command.
struct Questions {
  std::optional<std::vector<std::string>> requested = {};  ///< none: all
  std::optional<std::string> of_case = {};  ///< only those of this case ("" the base model); none: of all
  std::string command = {};                 ///< that answers one question, "modes" for example; empty: all are answered
  int lowest_modes = 0;                     ///< of the command `modes`; 0: what the file says
};

/// True if errors of this question in this case concern the command.
[[nodiscard]] bool is_requested(const std::string& question, const Questions& questions, const std::string& of_case);

/// True if the command does not answer this question itself, but judges requirements with its settings.
[[nodiscard]] bool is_only_setting(const std::string& question, const Questions& questions, const std::string& of_case);

/// The part of the analyses of a file that a command for these questions takes, where the size of a model depends on
/// it: `modes` takes only these, `response` only the response with its limits.
[[nodiscard]] Analyses counted_part(const Questions& questions, const Analyses& analyses);

/// Reports analyses and requirements that do not suit the model. An analysis of which requirements only take the
/// settings is not judged: one that has no answer has its reason beside all others.
/// @param system  a nonlinear one at rest
void check_analyses(const model::System& system, const Analyses& asked, const Questions& questions,
                    const std::string& of_case, foundation::Problems& problems);

/// Bands of the questions of question_table.h that have one, by their names, in the order of the table.
[[nodiscard]] std::vector<std::pair<std::string, assembly::Band>> asked_bands(const Analyses& asked);

/// True if the file asks for a response or for peaks that were removed from a case because of errors.
[[nodiscard]] bool has_broken_curves(const Case& variant);

/// Problems of the model and of the requested questions. Removes questions with errors that were not requested from
/// `analyses`.
[[nodiscard]] foundation::Problems without_unrequested(const foundation::Problems& found, const Questions& questions,
                                                       const std::string& of_case, Analyses& analyses);

/// Warnings of excitations that no question of the file uses in any case. None if no question takes excitations (modes
/// only, for example), because then the commands add the questions.
[[nodiscard]] foundation::Problems unused_parts(const std::vector<Case>& cases);

}  // namespace trivet::project
