// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/shown_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "trivet/documents/html_table.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"

namespace trivet::documents {
namespace {

bool has_own_unit(Kind kind) { return kind == Kind::quantity || kind == Kind::amplitude; }

DisplayUnit display_unit_of(Kind kind, const std::string& si_unit, const project::DisplayUnits& display) {
  return kind == Kind::amplitude ? amplitude_unit(display, si_unit) : display_unit(display, si_unit);
}

/// A value with its unit and prefix.
std::string with_unit(double value, const DisplayUnit& unit, int digits) {
  if (!std::isfinite(value)) return number_text(value);
  if (value == 0 || unit.unit == "1") return fixed_digits(value * unit.factor, digits);
  const UnitPrefix prefix = unit_prefix(std::abs(value), unit);
  return fixed_digits(value * prefix.factor, digits) + " " + prefix.unit;
}

double number_or_nothing(const Json& value) { return value.is_number() ? value.get<double>() : nothing; }

class Writing {
 public:
  Writing(const Table& table, const project::DisplayUnits& display, Form form)
      : table_(table), display_(display), columns_(used_columns(table, table.people, form)) {
    std::erase_if(columns_,
                  [&](const UsedColumn& used) { return used.column->heading.empty() || !(used.column->forms & form); });
    rows_.resize(table.rows);
    std::iota(rows_.begin(), rows_.end(), std::size_t{0});
    if (table.people_rows) rows_ = *table.people_rows;
    for (const UsedColumn& used : columns_)
      if (has_own_unit(used.column->kind))
        for (const std::size_t i : rows_)
          largest_[group_of(*used.column)].add(unit_in_row(table, *used.column, i),
                                               number_or_nothing(used.column->value(i)));
    for (const UsedColumn& used : columns_) add_common_unit(*used.column);
  }

  [[nodiscard]] ShownTable shown() const {
    ShownTable shown;
    for (const UsedColumn& used : columns_) add_headings(*used.column, shown);
    for (const std::size_t i : rows_) {
      ShownTable::Row& row = shown.rows.emplace_back();
      if (table_.mark) row.mark = table_.mark(i);
      for (const UsedColumn& used : columns_) add_cells(*used.column, i, row.cells);
    }
    return shown;
  }

 private:
  /// Columns whose numbers are of one kind, such as the components of a vector: those with one unit in all rows. A
  /// column with units of its rows may be a limit beside what it limits, and stands alone.
  static std::string group_of(const Column& column) {
    const bool of_rows = column.unit == unit_of_the_row || column.unit.starts_with('@');
    return of_rows ? "column " + column.name : "components";
  }

  [[nodiscard]] const LargestOfKind& of_group(const Column& column) const { return largest_.at(group_of(column)); }

  /// The unit of a quantity that is the same in all rows, with the prefix for the largest number.
  void add_common_unit(const Column& column) {
    if (!has_own_unit(column.kind) || column.unit == unit_of_the_row || column.unit.starts_with('@')) return;
    double largest = 0;
    for (const UsedColumn& other : columns_) {
      const bool same_unit = has_own_unit(other.column->kind) && other.column->unit == column.unit;
      if (other.column != &column && !(table_.one_prefix && same_unit)) continue;
      for (const std::size_t i : rows_) {
        const double size = std::abs(of_group(column).shown(column.unit, number_or_nothing(other.column->value(i))));
        if (std::isfinite(size)) largest = std::max(largest, size);
      }
    }
    common_units_[&column] = unit_prefix(largest, display_unit_of(column.kind, column.unit, display_));
  }

  void add_headings(const Column& column, ShownTable& shown) const {
    const auto add = [&](const std::string& heading) {
      shown.headings.push_back(heading);
      shown.numbers.push_back(column.kind != Kind::words && column.kind != Kind::yes_no);
      shown.frequencies.push_back(column.kind == Kind::speed || column.kind == Kind::frequency);
    };
    const bool is_omega = column.heading == "ω" && column.kind != Kind::number;
    if (is_omega) {
      add(frequency_heading(display_));
    } else if (column.kind == Kind::frequency) {
      add(column.heading + " [" + frequency_unit(display_) + "]");
    } else if (column.kind == Kind::speed) {
      add(column.heading + " [rpm]");
    } else if (common_units_.contains(&column)) {
      add(column.heading + " [" + common_units_.at(&column).unit + "]");
    } else {
      const std::string unit = column.kind == Kind::number ? display_unit(display_, column.unit).unit : "";
      const std::string in_brackets = unit.empty() || unit == "1" || unit == unit_of_the_row ? "" : " [" + unit + "]";
      for (const std::string& entry : column.entries) add(entry + in_brackets);
      if (!column.list) add(column.heading + in_brackets);
    }
  }

  void add_cells(const Column& column, std::size_t row, std::vector<std::string>& cells) const {
    if (column.list) {
      const Numbers list = column.list(row);
      const double factor = display_unit(display_, column.unit).factor;
      double largest = 0;
      for (std::size_t j = 0; j < list.size(); ++j) largest = std::max(largest, std::abs(list[j].real()));
      for (std::size_t j = 0; j < column.entries.size(); ++j)
        cells.push_back(fixed_digits(j < list.size() ? without_round_off(list[j].real(), largest) * factor : nothing,
                                     column.digits));
      return;
    }
    const Json value = column.value(row);
    if (value.is_null()) return cells.emplace_back("–"), void();
    if (value.is_string()) return cells.push_back(value.get<std::string>());
    if (value.is_boolean()) return cells.emplace_back(value.get<bool>() ? "yes" : "no"), void();
    add_number(column, row, value, cells);
  }

  void add_number(const Column& column, std::size_t row, const Json& value, std::vector<std::string>& cells) const {
    const double number = value.get<double>();
    if (column.kind == Kind::number) {
      if (value.is_number_integer()) cells.push_back(value.dump());
      else cells.push_back(number_text(number * display_unit(display_, column.unit).factor, column.digits));
    } else if (column.kind == Kind::share) {
      cells.push_back(std::isfinite(number) ? percent(number) : number_text(number));
    } else if (column.kind == Kind::speed) {
      cells.push_back(fixed_digits(converted(number, "rad/s", "rpm"), column.digits));
    } else if (common_units_.contains(&column)) {
      cells.push_back(
          fixed_digits(of_group(column).shown(column.unit, number) * common_units_.at(&column).factor, column.digits));
    } else if (has_own_unit(column.kind)) {
      const std::string unit = unit_in_row(table_, column, row);
      cells.push_back(
          with_unit(of_group(column).shown(unit, number), display_unit_of(column.kind, unit, display_), column.digits));
    } else {
      cells.push_back(fixed_digits(shown_frequency(display_, number), column.digits));
    }
  }

  const Table& table_;
  const project::DisplayUnits& display_;
  std::vector<UsedColumn> columns_;
  std::vector<std::size_t> rows_;
  std::map<const Column*, UnitPrefix> common_units_;
  std::map<std::string, LargestOfKind> largest_;  ///< by group of columns; much smaller ones are round-off
};

}  // namespace

ShownTable shown_table(const Table& table, const project::DisplayUnits& display, Form form) {
  return Writing(table, display, form).shown();
}

std::string fixed_digits(double value, int digits) {
  return std::isfinite(value) ? aligned_number(value, digits) : number_text(value);
}

std::string shown_quantity(const Quantity& quantity, const project::DisplayUnits& display) {
  const auto number = [&](double value) { return number_text(value, quantity.digits); };
  switch (quantity.kind) {
    case Kind::share:
      return percent(quantity.value);
    case Kind::speed:
      return number(converted(quantity.value, "rad/s", "rpm")) + " rpm";
    case Kind::frequency:
      return number(shown_frequency(display, quantity.value)) + " " + frequency_unit(display);
    case Kind::number:
      return number(quantity.value) + " " + quantity.unit;
    default:
      break;
  }
  const DisplayUnit unit = display_unit_of(quantity.kind, quantity.unit, display);
  if (!std::isfinite(quantity.value) || quantity.value == 0 || unit.unit == "1" || unit.unit.empty())
    return number(quantity.value * unit.factor);
  const UnitPrefix prefix = unit_prefix(std::abs(quantity.value), unit);
  return number(quantity.value * prefix.factor) + " " + prefix.unit;
}

std::string shown_sentence(const Sentence& sentence, const project::DisplayUnits& display) {
  std::string text;
  for (const auto& part : sentence.parts)
    text += std::holds_alternative<Quantity>(part) ? shown_quantity(std::get<Quantity>(part), display)
                                                   : std::get<std::string>(part);
  return text;
}

}  // namespace trivet::documents
