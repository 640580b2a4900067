// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/column_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

std::string ColumnQuantity::unit() const {
  if (!bare_unit.empty()) return bare_unit;
  return density ? density_unit(quantity) : si_unit(quantity);
}

ColumnQuantity ColumnQuantity::at_levels(Levels which, Level bare_level) const {
  ColumnQuantity column = *this;
  column.levels = which;
  column.level = bare_level;
  return column;
}

ColumnQuantity in_hertz() { return {Quantity::angular_frequency, foundation::two_pi, "Hz"}; }

ColumnQuantity density_of(Quantity quantity) { return {quantity, 1, "", true}; }

tl::expected<double, std::string> in_column_unit(const std::string& text, const ColumnQuantity& column) {
  auto value = column.density ? to_density(text, column.quantity)
                              : to_si_at_level(text, column.quantity, column.levels, column.level);
  if (value) *value /= column.bare;
  return value;
}

UnitHeading unit_heading(const std::string& column) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
    const std::size_t at = column.find(open);
    if (at == std::string::npos || at == 0 || column.back() != close) continue;
    const std::size_t end = column.find_last_not_of(' ', at - 1);
    if (end == std::string::npos) continue;
    return {column.substr(0, end + 1), column.substr(at + 1, column.size() - at - 2)};
  }
  return {column, ""};
}

std::set<std::string> convert_columns(CsvTable& table,
                                      const std::function<std::optional<ColumnQuantity>(const std::string&)>& known,
                                      foundation::Problems& problems) {
  std::set<std::string> converted;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const UnitHeading heading = unit_heading(table.columns[i]);
    if (heading.unit.empty()) continue;
    for (const char* ending : {"", "_hz", "_deg"}) {
      const std::string name = heading.name + ending;
      const auto column = known(name);
      if (!column) continue;
      if (const std::string unit = split_level(heading.unit).number;
          column->quantity != Quantity::pure && !unit_ratio(unit, unit))
        break;  // "acc (filtered)"
      const bool plain = column->quantity == Quantity::pure && (heading.unit == "-" || heading.unit == "1");
      const auto factor = plain ? tl::expected<double, std::string>(1) : in_column_unit("1 " + heading.unit, *column);
      if (!factor) {
        problems
            .error("", "column " + foundation::quoted(table.columns[i]), factor.error(),
                   column->quantity == Quantity::pure ? "remove the unit"
                                                      : "write a unit that converts to " + column->unit())
            .origin = {table.source, 0, 0};
      } else {
        table.values.col(to_index(i)) *= *factor;
      }
      // "force [N]" and "force [kN]" differ for the reader of the file, but not here.
      if (std::ranges::find(table.columns, name) != table.columns.end()) {
        problems
            .error("",
                   "column " + foundation::quoted(table.columns[i]) + ": another column is " + foundation::quoted(name),
                   "every column has a different name without its unit", "remove or rename one")
            .origin = {table.source, 0, 0};
      }
      table.columns[i] = name;
      converted.insert(name);
      break;
    }
  }
  return converted;
}

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
