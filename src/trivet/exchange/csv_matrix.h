// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

/// Reads a square matrix of real numbers, one row per line, with commas, semicolons, tabs or blanks between the
/// numbers. Lines that start with # and blank lines are skipped; a first line of words is a heading. No labels.
[[nodiscard]] foundation::Expected<NamedMatrix> read_csv_matrix(std::string_view text, const std::string& source);

}  // namespace trivet::exchange
