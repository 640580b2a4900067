// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/engine/session.h"

/// Names in a project, for completion in a shell, and words of a command line.
namespace trivet::engine {

/// One word of a shell.
[[nodiscard]] std::string shell_word(const std::string& text);
/// The word of a command line that means a project: its file, or - for standard input.
[[nodiscard]] std::string project_word(const project::Project& project);

/// What `of` may name in the base model: "machine", "machine.z", "mount.force.z", "ground".
[[nodiscard]] std::vector<std::string> result_names(const Session& session);

/// Paths of the numbers of the file, as settings name them: "elements.front.at.z". Arrays of three have components,
/// other arrays are one number.
[[nodiscard]] std::vector<std::string> number_paths(const Session& session);

}  // namespace trivet::engine
