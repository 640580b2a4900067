// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/project/text/display_units.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// One value that a case or the command line sets.
struct ChangedNumber {
  std::string path, value;
};

/// Changes of the command line. No two settings change the same number.
struct Settings {
  std::vector<Node> changes;
  std::vector<ChangedNumber> numbers;
};

/// @param folder  to which names of files in settings are relative
[[nodiscard]] Settings read_settings(const std::vector<std::string>& settings, const std::filesystem::path& folder,
                                     foundation::Problems& problems);

/// Makes names of files in all texts of a node relative to this folder.
void set_folder(Node& node, const std::string& folder);

/// Changes of a case that the command line does not override, then those of the command line.
[[nodiscard]] std::vector<std::string> change_lines(const Node* of_case, const Settings& settings,
                                                    const Node& document);

/// Reads [display].
[[nodiscard]] DisplayUnits read_display(TableReader& root);

}  // namespace trivet::project
