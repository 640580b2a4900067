// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "trivet/exchange/universal/universal_numbers.h"
#include "trivet/exchange/universal/universal_sets.h"

/// Records that sets 55 and 58 have in common: id lines and lines of numbers.
namespace trivet::exchange {

inline constexpr std::size_t universal_id_lines = 5;

/// One line of the head of a set.
struct HeadLine {
  std::string_view text;
  int line = 0;         ///< in the file
  std::size_t end = 0;  ///< bytes of the body up to the end of this line
};

/// The first lines of a set, at most `count`.
[[nodiscard]] std::vector<HeadLine> head_lines(const UniversalSet& set, std::size_t count);

/// The first `present` of the five id lines. Warns if some are missing or blank, or not UTF-8.
[[nodiscard]] std::array<std::string, universal_id_lines> read_ids(const std::vector<HeadLine>& head,
                                                                   std::size_t present, SetProblems& problems);

/// The numbers of one line of values: separated by blanks, or in columns if that fails, with a warning.
/// nullopt with an error if a number is missing or not finite.
[[nodiscard]] std::optional<std::vector<double>> values_of_line(std::string_view text, int line, FieldWidths widths,
                                                                SetProblems& problems);

}  // namespace trivet::exchange
