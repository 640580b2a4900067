// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"

namespace trivet::exchange {

// Numbers and texts in the records of universal files: in fixed columns, or separated by blanks.

/// Widths of the fields of a record [characters].
using FieldWidths = std::span<const int>;

/// The numbers of a line, separated by blanks; nullopt if a part is not a finite number.
[[nodiscard]] std::optional<std::vector<double>> numbers_between_blanks(std::string_view line);

enum class BlankFields { end_the_line, are_zero };

/// The numbers of a line in fixed columns, also without blanks between them; nullopt if a field is not a finite number.
[[nodiscard]] std::optional<std::vector<double>> numbers_in_columns(std::string_view line, FieldWidths widths,
                                                                    BlankFields blank);

/// The numbers of a record: between blanks if there are as many as fields, otherwise in columns with blank fields as
/// zero, otherwise between blanks if there are at least `least`, followed by zeros.
/// nullopt if none of these gives finite numbers.
[[nodiscard]] std::optional<std::vector<double>> numbers_of_record(std::string_view line, FieldWidths widths,
                                                                   std::size_t least);

/// The number as int if it is whole and in its range.
[[nodiscard]] std::optional<int> as_whole_number(double value);

/// The same as numbers_of_record if all numbers are whole.
[[nodiscard]] std::optional<std::vector<int>> whole_numbers_of_record(std::string_view line, FieldWidths widths,
                                                                      std::size_t least);

/// Trimmed part of a line of UTF-8; columns count characters from 0.
[[nodiscard]] std::string_view text_in_columns(std::string_view line, std::size_t first, std::size_t width);

/// A line as printable UTF-8 for texts: tabs become blanks, bytes that are not UTF-8 are read as Latin-1.
[[nodiscard]] std::string readable_line(std::string_view line);

/// A text of a record: trimmed, and empty for NONE.
[[nodiscard]] std::string unless_none(std::string_view text);

// Lines of the sets that are written.

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
