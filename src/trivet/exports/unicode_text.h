// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::exports {

/// Code points of a text in UTF-8; bytes that are none become U+FFFD.
[[nodiscard]] std::u32string code_points(const std::string& text);

/// The text in UTF-16.
[[nodiscard]] std::u16string utf16(const std::string& text);

}  // namespace trivet::exports
