// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/bare_headings.h"

#include <string>
#include <utility>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {
namespace {

foundation::Problems error_in_line(const CsvTable& table, int line, std::string finding, std::string rule,
                                   std::string remedy) {
  foundation::Problems found;
  found.error("", std::move(finding), std::move(rule), std::move(remedy)).origin = {table.source, line, 0};
  return found;
}

void warn_in_line(CsvTable& table, int line, std::string finding, std::string rule, std::string remedy) {
  table.warnings.warning("", std::move(finding), std::move(rule), std::move(remedy)).origin = {table.source, line, 0};
}

/// True if the first column increases from this row on.
bool increases_from(const CsvTable& table, Eigen::Index first) {
  for (Eigen::Index i = first + 1; i < table.values.rows(); ++i)
    if (!(table.values(i, 0) > table.values(i - 1, 0))) return false;
  return table.values.rows() - first > 1;
}

}  // namespace

foundation::Problems drop_row_numbers(CsvTable& table, int header_line) {
  const Eigen::Index rows = table.values.rows();
  const double first = rows > 0 ? table.values(0, 0) : 0;
  bool counts = first == 0 || first == 1;
  for (Eigen::Index i = 0; i < rows; ++i) counts = counts && table.values(i, 0) == first + static_cast<double>(i);
  if (!counts) return error_in_line(table, header_line, "column 1 has no name", "every column has a name", "name it");
  warn_in_line(table, header_line, "the first column has no name and counts the rows", "every column has a name",
               "it is ignored; write the table without its row numbers");
  table.values = table.values.rightCols(table.values.cols() - 1).eval();
  table.columns.erase(table.columns.begin());
  return {};
}

foundation::Problems judge_bare_heading(CsvTable& table, const BareHeading& heading) {
  const std::string as = foundation::comma_separated(table.columns);
  const bool is_data = increases_from(table, 0), numbered = heading.counts_columns && increases_from(table, 1);
  if (numbered && is_data && !heading.whole_below)
    return error_in_line(table, heading.line, "the first row counts the columns, or is the first of the numbers",
                         "a table has a header row that names the columns",
                         "write the header " + as + " in its place, or above it");
  if (!is_data && !numbered)
    return error_in_line(table, heading.line, "the first row holds numbers, and the first column does not increase",
                         "the first row names the columns", "add a header row: " + as);
  if (is_data) {
    warn_in_line(table, heading.line, "no header row", "a header names the columns: " + as,
                 "its columns are read in this order, in the units of such a column");
    return {};
  }
  warn_in_line(table, heading.line, "the header counts the columns", "a header names the columns: " + as,
               "its columns are read in this order");
  table.values = table.values.bottomRows(table.values.rows() - 1).eval();
  table.lines.erase(table.lines.begin());
  return {};
}

}  // namespace trivet::project
