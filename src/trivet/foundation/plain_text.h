// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// External text for terminals, tables and pictures.
namespace trivet::foundation {

/// Largest length of a name or text quoted in a message [bytes].
inline constexpr std::size_t longest_shown = 60;

/// The beginning of a text, at most `longest` bytes, not cut within a character of UTF-8.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t longest = longest_shown);

/// The same in double quotes, with "…" if it was cut.
[[nodiscard]] std::string quoted(std::string_view text, std::size_t longest = longest_shown);

/// "A, B and 3 more": at most `most` names, each shortened.
[[nodiscard]] std::string comma_separated(const std::vector<std::string>& names, std::size_t most = 12);

/// The text as one printable line of UTF-8: control characters as `\x1b` or `\u202e`, a line break as `\n`, bytes that
/// are not UTF-8 as `\xe9`.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// Description of the first character not allowed in names: a control character, one that changes the writing
/// direction, or a byte that is not UTF-8; nullopt if the text is printable. Line breaks and tabs count only if
/// `one_line`.
[[nodiscard]] std::optional<std::string> unprintable(std::string_view text, bool one_line = true);

/// A byte of a text that is not UTF-8; line and place in it count from 1.
struct ForeignByte {
  int line = 0;
  int place = 0;  ///< in bytes
  unsigned byte = 0;
};
/// The first one; nullopt if the text is UTF-8.
[[nodiscard]] std::optional<ForeignByte> first_foreign_byte(std::string_view text);

/// A name as part of a dotted path in a project file: in quotes unless it has only letters, digits, _ and -.
[[nodiscard]] std::string path_key(std::string_view name);

}  // namespace trivet::foundation
