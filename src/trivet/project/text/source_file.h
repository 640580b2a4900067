// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "trivet/foundation/problems.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// True for the keys that name a file relative to the project file.
[[nodiscard]] bool is_file_key(const std::string& key);

/// Path of the file that a text names.
[[nodiscard]] std::filesystem::path named_file(const Node& name);

/// Path of a file that the project file names relative to its folder. A missing key is a problem.
[[nodiscard]] std::optional<std::filesystem::path> read_file_name(TableReader& reader, const std::string& key);

/// Largest project file that is read.
inline constexpr std::uintmax_t largest_project_file = 16u << 20;

/// Bytes of a file; rejects directories, devices, unreadable and too large files.
[[nodiscard]] foundation::Expected<std::string> read_bytes(const std::filesystem::path& path,
                                                           const std::string& kind = "project file");
/// Has the text nothing but blanks?
[[nodiscard]] bool is_blank(std::string_view text);
/// Why the bytes of a file are no text: blank, or with NUL bytes.
[[nodiscard]] foundation::Problems source_problems(std::string_view bytes, const std::filesystem::path& path,
                                                   const std::string& kind = "project file");

/// Why a text is not UTF-8: line and byte of the first place. None if it is.
[[nodiscard]] foundation::Problems encoding_problems(std::string_view text, const std::string& source);

/// Text of a project file or a catalogue; rejects directories and unreadable, empty, binary and too large files.
[[nodiscard]] foundation::Expected<std::string> read_source(const std::filesystem::path& path,
                                                            const std::string& kind = "project file");

/// SHA-256 of a text, hexadecimal.
[[nodiscard]] std::string sha256(const std::string& text);

}  // namespace trivet::project
