// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/exchange/named_matrix.h"
#include "trivet/exchange/text_lines.h"

namespace trivet::exchange {

/// One entry as a file gives it; row and column count from 0.
struct Entry {
  int row = 0;
  int column = 0;
  double real = 0;
  double imaginary = 0;
  int line = 0;
};

/// What a file leaves out: nothing, or one of the two triangles.
enum class Triangles { both, one };

/// The dense matrix of the entries. Entries given twice, and a triangle that contradicts the other one where one would do,
/// are problems; then there is no result.
[[nodiscard]] std::optional<NamedMatrix> assembled(std::vector<Entry> entries, int order, Triangles triangles, bool is_complex, FileProblems& problems);

/// A problem for a matrix that is not square, or of an order below 1 or above `largest_order`.
void check_size(long long rows, long long columns, int line, FileProblems& problems);

}  // namespace trivet::exchange
