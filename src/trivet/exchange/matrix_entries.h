// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/exchange/named_matrix.h"
#include "trivet/exchange/text/text_lines.h"

namespace trivet::exchange {

/// One entry of a file; row and column count from 0.
struct Entry {
  int row = 0;
  int column = 0;
  double real = 0;
  double imaginary = 0;
  int line = 0;
};

/// Triangles that a file contains.
enum class Triangles { both, one };

/// Both triangles if the mirror image of any off-diagonal entry is present.
[[nodiscard]] Triangles triangles_of(const std::vector<Entry>& entries);

/// Errors for components that occur in two rows.
void check_labels(const std::vector<Label>& labels, int line, FileProblems& problems);

/// Dense matrix of the entries. Entries given twice, and unequal mirror images if one triangle is enough, are errors;
/// then the result is nullopt.
[[nodiscard]] std::optional<NamedMatrix> assembled(std::vector<Entry> entries, int order, Triangles triangles,
                                                   bool is_complex, FileProblems& problems);

/// Error if the matrix is not square, or its order is below 1 or above `largest_order`.
void check_size(long long rows, long long columns, int line, FileProblems& problems);

/// One entry of a file with node numbers.
struct LabelledEntry {
  Label row, column;
  Entry entry;  ///< its row and column are not set
};

/// The same for entries with labels; the rows are sorted by node and component.
[[nodiscard]] std::optional<NamedMatrix> assembled(const std::vector<LabelledEntry>& entries,
                                                   std::optional<Triangles> triangles, bool is_complex, int line,
                                                   FileProblems& problems);

}  // namespace trivet::exchange
