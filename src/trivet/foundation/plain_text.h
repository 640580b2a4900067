// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Text from outside that goes to terminals, tables and pictures.
namespace trivet::foundation {

/// The text as one printable line of UTF-8: control characters as \x1b or \u202e, a line break as \n, bytes that are no
/// UTF-8 as \xe9, and "…" for a character of several bytes that shortening has cut.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// Words for the first character that no name may hold: a control character, one that turns the direction of writing,
/// or a byte that is no UTF-8. None: the text is printable. Line breaks and tabs count only where `one_line`.
[[nodiscard]] std::optional<std::string> unprintable(std::string_view text, bool one_line = true);

}  // namespace trivet::foundation
