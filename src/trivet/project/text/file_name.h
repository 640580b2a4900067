// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// True for the keys that name a file relative to the project file.
[[nodiscard]] bool is_file_key(const std::string& key);

/// Path of the file that a text names.
[[nodiscard]] std::filesystem::path named_file(const Node& name);

/// Path of a file that the project file names relative to its folder. A missing key is a problem.
[[nodiscard]] std::optional<std::filesystem::path> read_file_name(TableReader& reader, const std::string& key);

}  // namespace trivet::project
