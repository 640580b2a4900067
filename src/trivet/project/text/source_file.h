// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::project {

/// Largest project file that is read.
inline constexpr std::uintmax_t largest_project_file = 16u << 20;

/// Text of a project file or a catalogue; rejects directories and unreadable, empty, binary and too large files.
[[nodiscard]] foundation::Expected<std::string> read_source(const std::filesystem::path& path,
                                                            const std::string& kind = "project file");

/// SHA-256 of a text, hexadecimal.
[[nodiscard]] std::string sha256(const std::string& text);

}  // namespace trivet::project
