// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/csv_matrix.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/exchange/matrix_entries.h"
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
  return std::none_of(row.begin(), row.end(), [](std::string_view cell) { return number(cell).has_value(); });
}

std::string remedy(std::string_view cell, char separator) {
  if (cell.empty()) return "write 0 for an entry that is zero";
  return separator == ';' && cell.find(',') != std::string_view::npos ? "write decimal points" : "correct the number";
}

struct NumberRows {
  std::vector<std::vector<double>> values;
  std::vector<int> lines;
};

NumberRows read_number_rows(std::string_view text, FileProblems& problems) {
  NumberRows rows;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  char separator = 0;
  for (Lines lines(text); !problems.enough() && lines.next();) {
    if (trimmed(lines.line()).empty() || trimmed(lines.line()).starts_with('#')) continue;
    const bool first = separator == 0;
    if (first) separator = separator_of(lines.line());
    const auto row = cells_of(lines.line(), separator);
    if (first && is_heading(row)) {
      problems.warning(lines.number(), "heading", in_quotes(lines.line()),
                       "a line without a number is not a row of the matrix", "start it with # as a comment");
      continue;
    }
    if (!rows.values.empty() && row.size() != rows.values.front().size())
      problems.error(lines.number(), "row", fmt::format("{} numbers", row.size()),
                     fmt::format("the row in line {} has {}", rows.lines.front(), rows.values.front().size()),
                     "every row has as many numbers as there are rows");
    if (rows.values.size() == largest_order || row.size() > largest_order) {
      check_size(largest_order + 1, largest_order + 1, lines.number(), problems);
      return rows;
    }
    std::vector<double> values;
    for (std::size_t j = 0; j < row.size() && !problems.enough(); ++j) {
      const auto value = number(row[j]);
      if (!value)
        problems.error(lines.number(), fmt::format("entry ({}, {})", rows.values.size() + 1, j + 1), in_quotes(row[j]),
                       "every entry is a finite number", remedy(row[j], separator));
      values.push_back(value.value_or(0));
    }
    rows.values.push_back(std::move(values));
    rows.lines.push_back(lines.number());
  }
  return rows;
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
    matrix.values.row(i) = Eigen::Map<const Eigen::RowVectorXd>(rows.values[to_size(i)].data(), order);
  matrix.warnings = problems.all();
  return matrix;
}

}  // namespace trivet::exchange
