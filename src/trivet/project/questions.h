// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "trivet/project/project.h"

/// What a file asks, apart from the model that it describes: keys of `analyses`, and `limits`, `limit_lines`.
namespace trivet::project {

/// The questions whose errors count. A command that answers one of them is not stopped by an error in another.
struct Questions {
  std::optional<std::vector<std::string>> wanted = {};  ///< none: all of them
  std::optional<std::string> of_case = {};              ///< those of this case alone ("" the base model); none: of all
};

/// As `read_project`, but questions with errors that are not wanted are left out of the analyses of their case.
[[nodiscard]] foundation::Expected<Project> read_project_for(const Questions& questions,
                                                             const std::filesystem::path& path,
                                                             const std::vector<std::string>& settings = {});

/// Does the file ask for a response or for peaks, which were left out of the analyses of a case for their errors?
[[nodiscard]] bool has_broken_curves(const Case& variant);

/// Problems of the model and of the wanted questions. A question with an error that is not wanted is removed from
/// `analyses`.
[[nodiscard]] foundation::Problems without_unwanted(const foundation::Problems& found, const Questions& questions,
                                                    const std::string& of_case, Analyses& analyses);

/// Warnings of excitations that none of the questions of the file uses, in any of its cases. None if no question takes
/// excitations (modes, say), since then the questions come with the commands.
[[nodiscard]] foundation::Problems unused_parts(const std::vector<Case>& cases);

}  // namespace trivet::project
