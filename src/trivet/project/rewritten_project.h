// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/project/project.h"

namespace trivet::project {

/// The text of a project file with other numbers in its base model, comments, order and format kept: --write of
/// `trivet optimize` and `trivet select`. The result was parsed again and has exactly these changes.
/// @param project   read from `project.source` with `settings`, whose changes are written too
/// @param changes   of the base model, as from ModelNumber::change
/// @param target    the file that the text is for
/// All problems at once: a number in another file, file names that are relative to another folder, a case that
/// overrides a setting, a number that cannot be written.
[[nodiscard]] foundation::Expected<std::string> rewritten_project(const Project& project,
                                                                  const std::vector<std::string>& settings,
                                                                  const std::vector<Node>& changes,
                                                                  const std::filesystem::path& target);

/// The text of a project that was read from `text` with `settings`, with these settings written in, as above.
[[nodiscard]] foundation::Expected<std::string> text_with_settings(const std::string& text, const Project& project,
                                                                   const std::vector<std::string>& settings);

/// True for a readable TOML file with the key `trivet`.
[[nodiscard]] bool is_project_file(const std::filesystem::path& path);

}  // namespace trivet::project
