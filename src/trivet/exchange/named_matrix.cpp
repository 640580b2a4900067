// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/named_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace trivet::exchange {

namespace {

std::string place(const Entry& entry) { return fmt::format("entry ({}, {})", entry.row + 1, entry.column + 1); }

bool equal(const Entry& a, const Entry& b) { return a.real == b.real && a.imaginary == b.imaginary; }

/// One entry of each mirrored pair; equal mirror images are dropped.
std::vector<Entry> folded(const std::vector<Entry>& sorted, FileProblems& problems) {
  std::vector<Entry> result;
  for (const Entry& entry : sorted) {
    const bool same_place =
        !result.empty() && std::minmax(entry.row, entry.column) == std::minmax(result.back().row, result.back().column);
    if (!same_place) {
      result.push_back(entry);
      continue;
    }
    const Entry& first = result.back();
    const bool mirrored = entry.row != first.row;
    if (!mirrored)
      problems.error(entry.line, place(entry), fmt::format("given again, first in line {}", first.line),
                     "an entry is given once", "remove one of the two");
    else if (!equal(entry, first))
      problems.error(
          entry.line, place(entry),
          fmt::format("{:.9g}, but its mirror image in line {} is {:.9g}", entry.real, first.line, first.real),
          "the file declares the matrix as symmetric", "correct the entry, or declare the matrix as general (square)");
    if (problems.enough()) break;
  }
  return result;
}

}  // namespace

void check_size(long long rows, long long columns, int line, FileProblems& problems) {
  if (rows != columns || rows < 1)
    problems.error(line, "size", fmt::format("{} × {}", rows, columns),
                   "a stiffness matrix is square with at least one row", "is this the right matrix?");
  else if (rows > largest_order)
    problems.error(line, "size", fmt::format("{} × {}", rows, columns),
                   fmt::format("a matrix of at most {0} × {0} is read", largest_order),
                   "condense the model to its interface nodes in the program that wrote it");
}

Triangles triangles_of(const std::vector<Entry>& entries) {
  std::set<std::pair<int, int>> upper;
  for (const Entry& entry : entries)
    if (entry.row < entry.column) upper.emplace(entry.row, entry.column);
  const auto mirrored = [&](const Entry& entry) {
    return entry.row > entry.column && upper.contains({entry.column, entry.row});
  };
  return std::ranges::any_of(entries, mirrored) ? Triangles::both : Triangles::one;
}

void check_labels(const std::vector<Label>& labels, int line, FileProblems& problems) {
  std::set<Label> seen;
  for (const Label& label : labels)
    if (!seen.insert(label).second && !problems.enough())
      problems.error(line, fmt::format("node {}, component {}", label.node, label.component), "named twice",
                     "every row is a different component", "correct the list of nodes");
}

std::optional<NamedMatrix> assembled(std::vector<Entry> entries, int order, Triangles triangles, bool is_complex,
                                     FileProblems& problems) {
  const auto key = [](const Entry& e) { return std::tuple(std::minmax(e.row, e.column), e.row < e.column, e.line); };
  std::ranges::stable_sort(entries, [&](const Entry& a, const Entry& b) { return key(a) < key(b); });
  if (triangles == Triangles::one) {
    entries = folded(entries, problems);
  } else {
    for (std::size_t i = 1; i < entries.size() && !problems.enough(); ++i)
      if (entries[i].row == entries[i - 1].row && entries[i].column == entries[i - 1].column)
        problems.error(entries[i].line, place(entries[i]),
                       fmt::format("given again, first in line {}", entries[i - 1].line), "an entry is given once",
                       "remove one of the two");
  }
  if (problems.any()) return std::nullopt;

  NamedMatrix matrix;
  matrix.values = Eigen::MatrixXd::Zero(order, order);
  if (is_complex) matrix.imaginary = Eigen::MatrixXd::Zero(order, order);
  for (const Entry& entry : entries) {
    const bool mirror = triangles == Triangles::one;
    matrix.values(entry.row, entry.column) = entry.real;
    if (mirror) matrix.values(entry.column, entry.row) = entry.real;
    if (is_complex) matrix.imaginary(entry.row, entry.column) = entry.imaginary;
    if (is_complex && mirror) matrix.imaginary(entry.column, entry.row) = entry.imaginary;
  }
  return matrix;
}

std::optional<NamedMatrix> assembled(const std::vector<LabelledEntry>& labelled, std::optional<Triangles> triangles,
                                     bool is_complex, int line, FileProblems& problems) {
  std::map<Label, int> rows;
  for (const LabelledEntry& entry : labelled) rows.emplace(entry.row, 0), rows.emplace(entry.column, 0);
  std::vector<Label> labels;
  for (auto& [label, row] : rows) {
    row = static_cast<int>(labels.size());
    labels.push_back(label);
  }
  check_size(static_cast<long long>(labels.size()), static_cast<long long>(labels.size()), line, problems);
  if (problems.any()) return std::nullopt;
  std::vector<Entry> entries;
  for (const LabelledEntry& one : labelled) {
    entries.push_back(one.entry);
    entries.back().row = rows.at(one.row), entries.back().column = rows.at(one.column);
  }
  const Triangles written = triangles.value_or(triangles_of(entries));
  auto matrix = assembled(std::move(entries), static_cast<int>(labels.size()), written, is_complex, problems);
  if (matrix) matrix->labels = std::move(labels);
  return matrix;
}

namespace {

std::vector<Label> read_rows(std::string_view text, FileProblems& problems) {
  std::vector<Label> labels;
  int last = 0;
  for (Lines lines(text); !problems.enough() && lines.next();) {
    const std::string_view line = trimmed(lines.line());
    if (line.empty()) continue;
    last = lines.number();
    const auto parts = cells(line, '.');
    const int node = whole_number(parts.front()).value_or(0), component = whole_number(parts.back()).value_or(0);
    if (parts.size() != 2 || node < 1 || component < 1 || component > 6) {
      problems.error(last, "row", in_quotes(line), "a row is node.component, 12.3 for instance, with component 1 to 6",
                     "is this the .dof file?");
    } else {
      labels.push_back({node, component});
    }
    if (labels.size() > largest_order) break;
  }
  if (!problems.any())
    check_size(static_cast<long long>(labels.size()), static_cast<long long>(labels.size()), last, problems);
  if (!problems.any()) check_labels(labels, last, problems);
  return labels;
}

}  // namespace

foundation::Expected<NamedMatrix> read_matrix_storage(std::string_view text, const std::string& source,
                                                      std::string_view rows, const std::string& rows_source) {
  FileProblems row_problems(rows_source);
  const std::vector<Label> labels = read_rows(rows, row_problems);
  if (row_problems.any()) return row_problems.refused();

  FileProblems problems(source);
  const int order = static_cast<int>(labels.size());
  std::vector<Entry> entries;
  for (Lines lines(text); !problems.enough() && lines.next();) {
    const auto parts = blank_separated(lines.line());
    if (parts.empty()) continue;
    const auto row = whole_number(parts[0]);
    const auto column = parts.size() == 3 ? whole_number(parts[1]) : std::nullopt;
    const auto value = column ? fortran_number(parts[2]) : std::nullopt;
    if (!row || !value)
      problems.error(lines.number(), "entry", in_quotes(lines.line()), "an entry is row, column and a finite number",
                     "correct the line");
    else if (*row < 1 || *row > order || *column < 1 || *column > order)
      problems.error(lines.number(), "entry", fmt::format("row {}, column {}", *row, *column),
                     fmt::format("{} has {} rows", rows_source, order), "do the two files belong together?");
    else entries.push_back({*row - 1, *column - 1, *value, 0, lines.number()});
  }
  if (!problems.any() && entries.empty())
    problems.error(0, "entries", "none", "the matrix must have entries", "did the program that wrote it finish?");
  if (problems.any()) return problems.refused();
  auto matrix = assembled(std::move(entries), order, Triangles::one, false, problems);
  if (!matrix) return problems.refused();
  matrix->labels = labels;
  return std::move(*matrix);
}

}  // namespace trivet::exchange
