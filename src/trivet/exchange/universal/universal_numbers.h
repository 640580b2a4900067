// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers and texts in the records of universal files: in fixed columns, or separated by blanks.
namespace trivet::exchange {

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

}  // namespace trivet::exchange
