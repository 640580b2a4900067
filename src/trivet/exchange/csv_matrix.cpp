// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/matrix_formats.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/exchange/named_matrix.h"
#include "trivet/foundation/index.h"

namespace trivet::exchange {
namespace {

constexpr char blank = ' ';

char separator_of(std::string_view line) {
  for (const char c : {';', ',', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return blank;
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  return separator == blank ? blank_separated(line) : cells(line, separator);
}

bool is_heading(const std::vector<std::string_view>& row) {
  return std::ranges::none_of(row, [](std::string_view cell) { return number(cell).has_value(); });
}

std::string remedy(std::string_view cell, char separator) {
  if (cell.empty()) return "write 0 for an entry that is zero";
  return separator == ';' && cell.find(',') != std::string_view::npos ? "write decimal points" : "correct the number";
}

/// Cells of the lines that are neither blank nor comments.
struct CellRows {
  std::vector<std::vector<std::string_view>> cells;
  std::vector<int> lines;
  char separator = 0;

  [[nodiscard]] std::size_t columns() const { return cells.empty() ? 0 : cells.front().size(); }
  void drop_first_row() {
    cells.erase(cells.begin());
    lines.erase(lines.begin());
  }
  void drop_column(std::size_t column) {
    for (auto& row : cells)
      if (column < row.size()) row.erase(row.begin() + to_index(column));
  }
};

std::string_view without_quotes(std::string_view cell) {
  const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

CellRows read_cells(std::string_view text, FileProblems& problems) {
  CellRows rows;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (Lines lines(text); lines.next();) {
    if (trimmed(lines.line()).empty() || trimmed(lines.line()).starts_with('#')) continue;
    if (rows.separator == 0) rows.separator = separator_of(lines.line());
    auto row = cells_of(lines.line(), rows.separator);
    for (std::string_view& cell : row) cell = without_quotes(cell);
    // Two more than the largest matrix: a heading, and a column that counts the rows.
    if (rows.cells.size() > largest_order + 1 || row.size() > largest_order + 2) {
      check_size(largest_order + 1, largest_order + 1, lines.number(), problems);
      return rows;
    }
    rows.cells.push_back(std::move(row));
    rows.lines.push_back(lines.number());
  }
  return rows;
}

/// Spreadsheets write separators after the last cell.
void drop_empty_last_columns(CellRows& rows) {
  while (rows.columns() > 1 && std::ranges::all_of(rows.cells, [&](const auto& row) {
           return row.size() == rows.columns() && row.back().empty();
         }))
    rows.drop_column(rows.columns() - 1);
}

/// True for 0, 1, 2 … or 1, 2, 3 …
template <typename Cells>
bool counts(const Cells& cells) {
  double expected = -1;
  for (const std::string_view cell : cells) {
    const auto value = number(cell);
    if (!value || (expected < 0 ? *value != 0 && *value != 1 : *value != expected)) return false;
    expected = *value + 1;
  }
  return expected > 0;
}

/// A heading without a number, or one that counts the columns of as many rows below it.
void drop_heading(CellRows& rows, std::string_view text, FileProblems& problems) {
  if (rows.cells.empty()) return;
  const int line = rows.lines.front();
  const auto& first = rows.cells.front();
  if (is_heading(first)) {
    problems.warning(line, "heading", in_quotes(text), "a line without a number is not a row of the matrix",
                     "start it with # as a comment");
    return rows.drop_first_row();
  }
  const std::size_t corner = first.size() > 1 && first.front().empty() ? 1 : 0;
  const std::vector<std::string_view> numbers(first.begin() + to_index(corner), first.end());
  if (rows.cells.size() != numbers.size() + 1 || !counts(numbers)) return;
  problems.warning(line, "heading", in_quotes(text), "a heading that counts the columns is not a row of the matrix",
                   "it is ignored; start it with # as a comment");
  rows.drop_first_row();
}

/// A first column that counts or names the rows of a matrix with one column fewer.
void drop_row_names(CellRows& rows, FileProblems& problems) {
  if (rows.columns() != rows.cells.size() + 1) return;
  std::vector<std::string_view> first;
  for (const auto& row : rows.cells) first.push_back(row.empty() ? std::string_view() : row.front());
  const bool names = std::ranges::none_of(first, [](std::string_view cell) { return cell.empty() || number(cell); });
  if (!names && !counts(first)) return;
  problems.warning(rows.lines.front(), "first column", names ? "names of the rows" : "numbers of the rows",
                   "a matrix has as many columns as rows", "it is ignored; write the matrix without it");
  rows.drop_column(0);
}

struct NumberRows {
  std::vector<std::vector<double>> values;
  std::vector<int> lines;
};

NumberRows numbers_of(const CellRows& cells, FileProblems& problems) {
  NumberRows rows;
  for (std::size_t i = 0; i < cells.cells.size() && !problems.enough(); ++i) {
    const auto& row = cells.cells[i];
    if (row.size() != cells.columns())
      problems.error(cells.lines[i], "row", fmt::format("{} numbers", row.size()),
                     fmt::format("the row in line {} has {}", cells.lines.front(), cells.columns()),
                     "every row has as many numbers as there are rows");
    std::vector<double> values;
    for (std::size_t j = 0; j < row.size() && !problems.enough(); ++j) {
      const auto value = number(row[j]);
      if (!value)
        problems.error(cells.lines[i], fmt::format("entry ({}, {})", i + 1, j + 1), in_quotes(row[j]),
                       "every entry is a finite number", remedy(row[j], cells.separator));
      values.push_back(value.value_or(0));
    }
    rows.values.push_back(std::move(values));
    rows.lines.push_back(cells.lines[i]);
  }
  return rows;
}

std::string_view line_of(std::string_view text, int number) {
  for (Lines lines(text); lines.next();)
    if (lines.number() == number) return lines.line();
  return {};
}

NumberRows read_number_rows(std::string_view text, FileProblems& problems) {
  CellRows rows = read_cells(text, problems);
  if (problems.any()) return {};
  drop_empty_last_columns(rows);
  drop_heading(rows, rows.lines.empty() ? std::string_view() : line_of(text, rows.lines.front()), problems);
  drop_row_names(rows, problems);
  return numbers_of(rows, problems);
}

}  // namespace

foundation::Expected<NamedMatrix> read_csv_matrix(std::string_view text, const std::string& source) {
  FileProblems problems(source);
  const NumberRows rows = read_number_rows(text, problems);
  if (!problems.any()) {
    const auto columns = rows.values.empty() ? 0 : rows.values.front().size();
    check_size(static_cast<long long>(rows.values.size()), static_cast<long long>(columns),
               rows.lines.empty() ? 0 : rows.lines.back(), problems);
  }
  if (problems.any()) return problems.refused();
  NamedMatrix matrix;
  const auto order = to_index(rows.values.size());
  matrix.values.resize(order, order);
  for (Eigen::Index i = 0; i < order; ++i)
    matrix.values.row(i) = Eigen::Map<const Eigen::RowVectorXd>(rows.values[i].data(), order);
  matrix.warnings = problems.all();
  return matrix;
}

}  // namespace trivet::exchange
