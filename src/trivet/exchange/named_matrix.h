// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/foundation/problems.h"

namespace trivet::exchange {

// Matrices from other programs, in the units, axes and order of their files.

/// Largest number of rows; such a matrix takes 288 MB.
inline constexpr int largest_order = 6000;

/// One degree of freedom of a finite-element model: 1, 2, 3 translations along and 4, 5, 6 rotations about x, y, z of a
/// node; component 0 is a scalar point.
struct Label {
  int node = 0;
  int component = 0;
  auto operator<=>(const Label&) const = default;
};

/// A square matrix with the labels of its rows (and columns).
struct NamedMatrix {
  Eigen::MatrixXd values;     ///< real part
  Eigen::MatrixXd imaginary;  ///< empty if the file is real
  std::vector<Label> labels;  ///< one per row; empty if the format has none
  foundation::Problems warnings;
};

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

/// Reads the matrix that CalculiX writes with *FREQUENCY, SOLVER=MATRIXSTORAGE: the upper triangle as row, column,
/// value (.sti or .mas) and node.component of every row (.dof).
[[nodiscard]] foundation::Expected<NamedMatrix> read_matrix_storage(std::string_view entries, const std::string& source,
                                                                    std::string_view rows,
                                                                    const std::string& rows_source);

}  // namespace trivet::exchange
