// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/universal/universal_file.h"

namespace trivet::exchange {

/// Form of the values of set 58; all other sets are text.
enum class FunctionForm { ascii, binary };

/// Longest texts of a universal file [characters].
inline constexpr std::size_t universal_id_width = 80;      ///< id lines, names of lines, texts of the header
inline constexpr std::size_t universal_entity_width = 10;  ///< names of response and reference
inline constexpr std::size_t universal_label_width = 20;   ///< labels of axes and units

/// True if a text is written unchanged as a whole line: printable, at most 80 bytes of UTF-8, without blanks around it,
/// and neither NONE nor -1. Other texts are cut. An empty text fits and is written as NONE.
[[nodiscard]] bool fits_universal_line(std::string_view text);

/// True if a text is written unchanged between other fields: at most `width` printable characters of ASCII, without
/// blanks around it, and not NONE. Other texts are cut, with ? for each other character.
[[nodiscard]] bool fits_universal_field(std::string_view text, std::size_t width);

/// The number that the format E13.5 of abscissas has: rounded to six digits. A grid rounded in this way, or first value
/// and step of an even one, is written without loss.
/// @throws InvalidInput if it is not finite
[[nodiscard]] double as_universal_abscissa(double hertz);

/// A universal file with the sets 151, 164 (SI), 15, 82, 55 and 58 or 58b. Numbers are given in SI, abscissas of
/// frequency in Hz. Digits: six for positions, modes, abscissas and values in single precision; thirteen for values in
/// double precision. In binary form values are exact, little-endian; functions with an uneven abscissa are in single
/// precision there, abscissa and values, because programs disagree about the size of the abscissa of values in double
/// precision. First abscissa and step of an even one are text with six digits also there.
/// `units_of_file` is not used.
/// @throws InvalidInput for numbers that are not finite, not in SI or too large for their columns, for sizes that
///   disagree, for a step ≤ 0, and for times or frequencies that do not increase when they are rounded
[[nodiscard]] std::string universal_text(const UniversalFile& file, FunctionForm form);

}  // namespace trivet::exchange
