// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"

/// Lines of the sets that are written.
namespace trivet::exchange {

/// "    -1" and the line with the type.
[[nodiscard]] std::string opening_lines(int type);
[[nodiscard]] std::string closing_line_of_set();

/// A text as a whole line, at most 80 bytes; NONE if it is blank.
[[nodiscard]] std::string text_line(std::string_view text);

/// A text in a field of this width, filled with blanks; NONE if it is empty.
[[nodiscard]] std::string text_field(std::string_view text, std::size_t width);

/// A whole number in a field, with at least one blank before it.
/// @throws InvalidInput if it is too large for the field; `name` names it
[[nodiscard]] std::string whole_field(int number, int width, const char* name);

/// Format E13.5: six digits.
[[nodiscard]] std::string single_field(double number);
/// Format E20.12: thirteen digits.
[[nodiscard]] std::string double_field(double number);

/// Numbers in lines of six fields of E13.5.
[[nodiscard]] std::string single_lines(const std::vector<double>& numbers);

/// @throws InvalidInput if the number is not finite
void require_finite(double number, const char* name);

/// Set 58 or, in binary form, 58b.
[[nodiscard]] std::string function_set(const UniversalFunction& function, bool binary);
/// @throws InvalidInput as in universal_text
void require_writable(const UniversalFunction& function, bool binary);

}  // namespace trivet::exchange
