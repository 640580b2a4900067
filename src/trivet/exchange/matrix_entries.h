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

/// Does any entry off the diagonal stand beside its mirror image? Then both triangles are written.
[[nodiscard]] Triangles triangles_of(const std::vector<Entry>& entries);

/// Two rows for the same component are a problem.
void check_labels(const std::vector<Label>& labels, int line, FileProblems& problems);

/// The dense matrix of the entries. Entries given twice, and a triangle that contradicts the other one where one would
/// do, are problems; then there is no result.
[[nodiscard]] std::optional<NamedMatrix> assembled(std::vector<Entry> entries, int order, Triangles triangles,
                                                   bool is_complex, FileProblems& problems);

/// A problem for a matrix that is not square, or of an order below 1 or above `largest_order`.
void check_size(long long rows, long long columns, int line, FileProblems& problems);

/// One entry as a file with node numbers gives it.
struct LabelledEntry {
  Label row, column;
  Entry entry;  ///< its row and column are not set
};

/// The same for entries with labels; the rows are sorted by node and component.
[[nodiscard]] std::optional<NamedMatrix> assembled(const std::vector<LabelledEntry>& entries,
                                                   std::optional<Triangles> triangles, bool is_complex, int line,
                                                   FileProblems& problems);

}  // namespace trivet::exchange
