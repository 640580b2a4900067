// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/level.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

// Columns of numbers whose cells or headings may have units.

/// What the numbers of a column measure, and in which unit those without one are.
struct ColumnQuantity {
  Quantity quantity = Quantity::pure;
  double bare = 1;                 ///< SI value of a 1 without a unit
  std::string bare_unit;           ///< "Hz"; empty: the SI unit
  bool density = false;            ///< the square of the quantity per hertz
  Levels levels = Levels::none;    ///< which may follow the unit
  Level level = Level::amplitude;  ///< of the numbers without one

  ColumnQuantity() = default;
  ColumnQuantity(Quantity measured) : quantity(measured) {}
  ColumnQuantity(Quantity measured, double one, std::string unit, bool is_density = false)
      : quantity(measured), bare(one), bare_unit(std::move(unit)), density(is_density) {}

  [[nodiscard]] ColumnQuantity at_levels(Levels which, Level bare_level) const;
  /// The unit of a number without one.
  [[nodiscard]] std::string unit() const;
};
/// Frequencies whose bare numbers are in hertz.
[[nodiscard]] ColumnQuantity in_hertz();
/// The densities of the squares of a quantity over hertz, bare ones in SI.
[[nodiscard]] ColumnQuantity density_of(Quantity quantity);

/// A text "4.5 mm/s" in the unit of the bare numbers of its column, or the reason why it has no such value.
[[nodiscard]] tl::expected<double, std::string> in_column_unit(const std::string& text, const ColumnQuantity& column);

/// The name of a column "force [kN]" or "force (kN)", and its unit; empty without one.
struct UnitHeading {
  std::string name, unit;
};
[[nodiscard]] UnitHeading unit_heading(const std::string& column);

/// Converts the columns whose headings have a unit in brackets to the unit of bare numbers, and removes the brackets.
/// "frequency [rad/s]" becomes frequency_hz, "crank_angle [rad]" becomes crank_angle_deg.
/// @param known  what the column of a name measures; none: it is not known and stays as it is
/// A column whose brackets hold no unit, "acc (filtered)", keeps its name.
/// @return the names of the columns that had a unit
std::set<std::string> convert_columns(CsvTable& table,
                                      const std::function<std::optional<ColumnQuantity>(const std::string&)>& known,
                                      foundation::Problems& problems);

// Tables that programs write with row numbers, or without names of their columns.

/// First row of a table whose cells are all numbers.
struct BareHeading {
  int line = 0;                 ///< in the file; 0: the table has a header
  bool counts_columns = false;  ///< it is 0, 1 … or 1, 2 …
  bool whole_below = false;     ///< rows below it have whole numbers, too
};

/// Removes the first column, which has no name, if it counts the rows, with a warning of the table; otherwise an error.
[[nodiscard]] foundation::Problems drop_row_numbers(CsvTable& table, int header_line);

/// Keeps a bare first row as numbers, or removes it if it counts the columns, with a warning of the table. Errors: it
/// may be either, or the first column does not increase.
[[nodiscard]] foundation::Problems judge_bare_heading(CsvTable& table, const BareHeading& heading);

}  // namespace trivet::project
