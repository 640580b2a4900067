// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/matrix_storage.h"

#include <fmt/format.h>

#include "trivet/exchange/matrix_entries.h"

namespace trivet::exchange {
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
