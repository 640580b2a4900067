// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace trivet::study {

/// A hidden name in the folder of `target`, of this process alone: what is made there takes the target's place by a rename.
[[nodiscard]] std::filesystem::path name_beside(const std::filesystem::path& target, const std::string& purpose);

/// Writes a whole file. @param shown  what a message calls it @throws std::runtime_error with the reason (a full disk, for instance)
void write_file(const std::filesystem::path& path, const std::string& content, const std::filesystem::path& shown);

}  // namespace trivet::study
