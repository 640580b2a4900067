// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

/// What can be stated about the text of a project file before it is opened, and also if it has errors.
namespace trivet::project {

/// Empty if there is none.
[[nodiscard]] std::string title_in_text(const std::string& text, const std::string& source);

/// A place in a project where the name of a file is written.
struct FileName {
  std::string path;            ///< "elements.mount.catalogue"
  std::string text;            ///< as written
  std::filesystem::path file;  ///< relative to its folder, links not resolved
  foundation::Origin origin;
};

/// Names of files in a text, which is TOML; otherwise there are none. No file is read.
[[nodiscard]] std::vector<FileName> files_named_in_text(const std::string& text, const std::string& source);
/// The same, with those in the rows of the tables of parts, whose files are read.
[[nodiscard]] std::vector<FileName> files_named_in_tables(const std::string& text, const std::string& source);
[[nodiscard]] std::vector<FileName> files_named_in_settings(const std::vector<std::string>& settings,
                                                            const std::filesystem::path& folder);

}  // namespace trivet::project
