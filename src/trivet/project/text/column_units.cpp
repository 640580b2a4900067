// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/column_units.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/derived_units.h"

namespace trivet::project {

std::string ColumnQuantity::unit() const {
  if (!bare_unit.empty()) return bare_unit;
  return density ? density_unit(quantity) : si_unit(quantity);
}

ColumnQuantity in_hertz() { return {Quantity::angular_frequency, foundation::two_pi, "Hz"}; }

ColumnQuantity density_of(Quantity quantity) { return {quantity, 1, "", true}; }

tl::expected<double, std::string> in_column_unit(const std::string& text, const ColumnQuantity& column) {
  auto value = column.density ? to_density(text, column.quantity) : to_si(text, column.quantity);
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
      if (column->quantity != Quantity::pure && !unit_ratio(heading.unit, heading.unit)) break;  // "acc (filtered)"
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

}  // namespace trivet::project
