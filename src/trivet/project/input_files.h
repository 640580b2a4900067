// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/project.h"

namespace trivet::project {

/// A file that a project names, with the SHA-256 of its bytes, hexadecimal.
struct InputFile {
  std::string name;  ///< as written in the project
  std::string sha256;
};

/// Files that the text of a project, its tables and its settings name, each once, in their order there. Files that
/// cannot be read are not among them.
[[nodiscard]] std::vector<InputFile> input_files(const Project& project);

/// SHA-256 of all input, hexadecimal: that of the project file with its settings if it names no other files, otherwise
/// that of this hash and those of `files`, one per line.
[[nodiscard]] std::string input_hash(const Project& project, const std::vector<InputFile>& files);
[[nodiscard]] std::string input_hash(const Project& project);

}  // namespace trivet::project
