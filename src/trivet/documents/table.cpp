// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/table.h"

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::documents {
namespace {

const Column* find_column(const Table& table, const std::string& name, unsigned form) {
  for (const Column& column : table.columns)
    if (column.name == name && (column.forms & form)) return &column;
  return nullptr;
}

const Column& column_of(const Table& table, const std::string& name, unsigned form) {
  if (const Column* found = find_column(table, name, form)) return *found;
  throw foundation::InvalidInput("the table has no column \"" + name + "\"");
}

}  // namespace

std::vector<UsedColumn> used_columns(const Table& table, const std::vector<Use>& uses, unsigned form) {
  std::vector<UsedColumn> used;
  if (uses.empty()) {
    for (const Column& column : table.columns)
      if (column.forms & form) used.push_back({column.name, &column, column.unit});
    return used;
  }
  for (const Use& use : uses) {
    const Column* whole = find_column(table, use.column, form);  // users' names may contain " ["
    const std::size_t bracket = whole ? std::string::npos : use.column.rfind(" [");
    const Column& column = whole ? *whole : column_of(table, use.column.substr(0, bracket), form);
    const bool other = !whole && (use.column.ends_with(" [Hz]") || use.column.ends_with(" [rpm]"));
    used.push_back(
        {use.name, &column, other ? use.column.substr(bracket + 2, use.column.size() - bracket - 3) : column.unit});
  }
  return used;
}

double converted(double value, const std::string& from, const std::string& to) {
  if (from != "rad/s" || from == to) return value;
  if (to == "Hz") return value / foundation::two_pi;
  return to == "rpm" ? value * 60 / foundation::two_pi : value;
}

Json value_of(const UsedColumn& used, std::size_t row) {
  Json value = used.column->value(row);
  if (value.is_number_float() && used.unit != used.column->unit)
    return converted(value.get<double>(), used.column->unit, used.unit);
  return value;
}

std::vector<std::size_t> spread_rows(std::size_t rows, std::size_t most) {
  std::vector<std::size_t> list;
  const std::size_t count = std::min(most, rows);
  for (std::size_t i = 0; i < count; ++i) list.push_back(count == 1 ? 0 : i * (rows - 1) / (count - 1));
  return list;
}

std::string unit_in_row(const Table& table, const Column& column, std::size_t row) {
  const bool own = column.unit.starts_with('@');
  if (!own && column.unit != unit_of_the_row) return column.unit;
  return column_of(table, own ? column.unit.substr(1) : "unit", everywhere).value(row).get<std::string>();
}

}  // namespace trivet::documents
