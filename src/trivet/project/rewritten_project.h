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
/// @param target  the file that the text is for; empty: names of files are not checked
[[nodiscard]] foundation::Expected<std::string> text_with_settings(const std::string& text, const Project& project,
                                                                   const std::vector<std::string>& settings,
                                                                   const std::filesystem::path& target = {});

/// Hash of all numbers and texts of a project in all its cases, and of the files that these name: equal for equal
/// projects, whatever their texts look like.
[[nodiscard]] std::string content_hash(const Project& project);

/// True for a readable TOML file with the key `trivet`.
[[nodiscard]] bool is_project_file(const std::filesystem::path& path);

}  // namespace trivet::project
