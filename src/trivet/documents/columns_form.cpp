// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "trivet/documents/csv_parts.h"
#include "trivet/documents/document.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/invalid_input.h"

/// The tables and curves of a document as typed columns, in the units of [display].
namespace trivet::documents {
namespace {

/// The unit of numbers with what they are multiplied by.
struct Shown {
  std::string unit;
  double factor = 1;
};

Shown shown_as(Kind kind, const std::string& unit, const project::DisplayUnits& display) {
  const bool is_frequency = kind == Kind::frequency || kind == Kind::speed;
  if (is_frequency && unit == "rad/s") return {frequency_unit(display, "rad/s"), shown_frequency(display, 1, "rad/s")};
  if (is_frequency && !display.frequency.empty())
    return {display.frequency, shown_frequency(display, 1 / converted(1, "rad/s", unit))};
  if (unit.empty()) return {};
  const DisplayUnit found =
      kind == Kind::amplitude ? amplitude_unit_of_data(display, unit) : display_unit(display, unit);
  return {found.label(), found.factor};
}

Json times(const Json& value, double factor) {
  if (!value.is_number()) return nullptr;
  if (value.is_number_integer() || factor == 1) return value;
  return value.get<double>() * factor;
}

/// CSV has the frequency in rad/s and in Hz, which are equal in one unit.
bool is_there(const std::vector<TypedColumn>& found, const std::string& name, const std::string& unit) {
  return std::ranges::any_of(found, [&](const TypedColumn& one) { return one.name == name && one.unit == unit; });
}

class TableColumns {
 public:
  TableColumns(const Table& table, const project::DisplayUnits& display) : table_(table), display_(display) {}

  std::vector<TypedColumn> found() {
    for (const UsedColumn& used : used_columns(table_, table_.csv, in_csv)) {
      if (used.column->list) add_lists(used);
      else add(used);
    }
    return std::move(found_);
  }

 private:
  static std::string unit_column(const Column& column) {
    return column.unit.starts_with('@') ? column.unit.substr(1) : "unit";
  }

  /// Shapes have a unit for each entry, and no column of units.
  bool is_of_row(const Column& column) const {
    return (column.unit.starts_with('@') || column.unit.starts_with(unit_of_the_row)) &&
        std::ranges::find(table_.columns, unit_column(column), &Column::name) != table_.columns.end();
  }

  Kind kind(const Column& column, std::size_t row) const {
    return column.kind_in_row ? column.kind_in_row(row) : column.kind;
  }

  Shown in_row(const Column& column, std::size_t row) const {
    // "unit of the row/s" becomes another unit by the same factor
    const Column& of_units = *std::ranges::find(table_.columns, unit_column(column), &Column::name);
    return shown_as(kind(column, row), of_units.value(row).get<std::string>(), display_);
  }

  void add(const UsedColumn& used) {
    const Column& column = *used.column;
    if (column.kind == Kind::words) return add_words(used.name, column);
    auto [name, unit] = parts_of(used.name);
    const Shown all = is_of_row(column) ? Shown{unit, 1} : shown_as(column.kind, unit, display_);
    name = column.kind == Kind::frequency ? name_in_unit(name, all.unit) : name;
    if (is_there(found_, name, all.unit)) return;
    TypedColumn& typed = found_.emplace_back(TypedColumn{name, all.unit, {}});
    for (std::size_t i = 0; i < table_.rows; ++i) {
      const Json value = value_of(used, i);
      if (value.is_string() || value.is_boolean()) typed.values.push_back(value);
      else typed.values.push_back(times(value, is_of_row(column) ? in_row(column, i).factor : all.factor));
    }
  }

  /// Units of rows become those of their numbers, and words with numbers are those for people if other units are shown.
  void add_words(const std::string& name, const Column& column) {
    const bool is_si = display_ == project::DisplayUnits{};
    const auto of_numbers = std::ranges::find(table_.columns, std::string(unit_of_the_row), &Column::unit);
    const bool is_unit = column.name == "unit" && of_numbers != table_.columns.end() && of_numbers->value;
    const bool names_unit = !parts_of(name).unit.empty();  // such words stay SI
    const auto for_readers = std::ranges::find_if(table_.columns, [&](const Column& other) {
      return &other != &column && other.name == column.name && other.kind == Kind::words && (other.forms & on_screen);
    });
    const Column& shown = is_si || names_unit || for_readers == table_.columns.end() ? column : *for_readers;
    TypedColumn& typed = found_.emplace_back(TypedColumn{name, "", {}});
    for (std::size_t i = 0; i < table_.rows; ++i)
      typed.values.push_back(is_unit ? Json(in_row(*of_numbers, i).unit) : shown.value(i));
  }

  void add_lists(const UsedColumn& used) {
    const Column& column = *used.column;
    for (std::size_t j = 0; j < column.entries.size(); ++j) {
      auto [name, unit] = parts_of(fmt::format(fmt::runtime(used.name), column.entries[j]));
      const Shown all = is_of_row(column) ? Shown{unit, 1} : shown_as(column.kind, unit, display_);
      TypedColumn& typed = found_.emplace_back(TypedColumn{name, all.unit, {}});
      for (std::size_t i = 0; i < table_.rows; ++i) {
        const Numbers list = column.list(i);
        const double factor = is_of_row(column) ? in_row(column, i).factor : all.factor;
        typed.values.push_back(j < list.size() ? Json(list[j].real() * factor) : Json(nullptr));
      }
    }
  }

  const Table& table_;
  const project::DisplayUnits& display_;
  std::vector<TypedColumn> found_;
};

std::vector<TypedColumn> columns_of(const Curves& curves, const project::DisplayUnits& display) {
  std::vector<TypedColumn> found;
  const auto add = [&](const std::string& heading, Kind kind, auto value_at) {
    const auto [stated, unit] = parts_of(heading);
    const Shown shown = shown_as(kind, unit, display);
    const std::string name = kind == Kind::frequency ? name_in_unit(stated, shown.unit) : stated;
    if (is_there(found, name, shown.unit)) return;
    TypedColumn& typed = found.emplace_back(TypedColumn{name, shown.unit, {}});
    for (std::size_t k = 0; k < curves.points.size(); ++k) typed.values.emplace_back(value_at(k) * shown.factor);
  };
  for (const std::string& heading : curves.axis_columns) {
    const std::string unit = parts_of(heading).unit;
    const bool is_frequency = unit == "rad/s" || unit == "Hz" || unit == "rpm";
    add(heading, is_frequency ? Kind::frequency : Kind::quantity,
        [&](std::size_t k) { return converted(curves.points[k].real(), curves.unit, unit); });
  }
  for (const Curve& curve : curves.list) {
    if (!(curve.forms & in_csv)) continue;
    const Kind kind = curve.harmonic ? Kind::amplitude : Kind::quantity;
    for (const CurveColumn& column : curve.csv)
      add(column.heading, kind, [&](std::size_t k) { return column.part(curve.values[k]); });
    if (curve.csv.empty())
      add(fmt::format("{} [{}]", curve.name, curve.unit), kind, [&](std::size_t k) {
        return curve.values.is_complex() ? std::abs(curve.values[k]) : curve.values[k].real();
      });
  }
  return found;
}

const Part* found_part(const std::vector<Part>& parts, const std::string& file) {
  for (const Part& part : parts) {
    if (const auto* table = std::get_if<Table>(&part.content); table && table->file == file) return &part;
    if (const auto* curves = std::get_if<Curves>(&part.content); curves && curves->file == file) return &part;
    if (const auto* group = std::get_if<Group>(&part.content))
      if (const Part* found = found_part(group->parts, file)) return found;
  }
  return nullptr;
}

}  // namespace

const Part& part_with_file(const Document& document, const std::string& file) {
  if (const Part* part = found_part(document.parts, file)) return *part;
  throw foundation::InvalidInput("the result has no table \"" + file + "\"");
}

HeadingParts parts_of(const std::string& heading) {
  const std::size_t bracket = heading.rfind(" [");
  if (bracket == std::string::npos || !heading.ends_with(']')) return {heading, ""};
  return {heading.substr(0, bracket), heading.substr(bracket + 2, heading.size() - bracket - 3)};
}

std::vector<TypedColumn> as_columns(const Document& document, const std::string& file,
                                    const project::DisplayUnits& display) {
  const Part& part = part_with_file(document, file);
  const auto* table = std::get_if<Table>(&part.content);
  std::vector<TypedColumn> all =
      table ? TableColumns(*table, display).found() : columns_of(std::get<Curves>(part.content), display);
  std::vector<TypedColumn> different;
  for (TypedColumn& one : all)
    if (std::ranges::none_of(different, [&](const TypedColumn& other) {
          return other.name == one.name && other.unit == one.unit && other.values == one.values;
        }))
      different.push_back(std::move(one));
  return different;
}

}  // namespace trivet::documents
