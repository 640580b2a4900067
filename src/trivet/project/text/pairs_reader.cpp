// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/pairs_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/unit_slips.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

namespace {

/// One cell of rows in the unit of the bare numbers of its column.
std::optional<double> read_cell(TableReader& reader, const Node& cell, const std::string& where,
                                const ColumnQuantity& column) {
  const bool has_level = cell.kind == Node::Kind::text && split_level(cell.text).level;
  const bool in_si = column.bare == 1 && !column.density && !has_level;
  if (in_si || cell.kind != Node::Kind::text)
    return reader.scalar(cell, where, in_si ? column.quantity : Quantity::pure);
  const auto value = in_column_unit(cell.text, column);
  const bool in_range = value && !outside_range(*value, Quantity::pure);
  if (!in_range)
    reader.problems()
        .error(where, value_text(cell), value ? *outside_range(*value, Quantity::pure) : value.error(),
               other_motion_advice(split_level(cell.text).number, column.quantity, where, column.density) +
                   fmt::format("give a number in {0}, or a text with a unit that converts to {0}", column.unit()))
        .origin = cell.origin;
  return in_range ? std::optional(*value) : std::nullopt;
}

/// Rejects a column in which only some numbers have a unit: who wrote it meant one unit, which the bare ones do not
/// have.
void check_mixed_units(TableReader& reader, const std::string& key, const Node& rows, std::size_t column,
                       const ColumnQuantity& quantity) {
  std::size_t with_unit = 0, bare = 0;
  for (const Node& row : rows.items) {
    const Node& cell = row.items[column];
    with_unit += cell.kind == Node::Kind::text;
    bare += cell.kind != Node::Kind::text && cell.number != 0;
  }
  if (with_unit > 0 && bare > 0)
    reader.error(key, fmt::format("{} numbers of column {} have a unit and {} have none", with_unit, column + 1, bare),
                 "the numbers of one column all have a unit, or none",
                 "write each with its unit; bare ones are in " + quantity.unit());
}

}  // namespace

std::optional<Eigen::MatrixXd> read_pairs(TableReader& reader, const std::string& key, const ColumnQuantity& x,
                                          const ColumnQuantity& y) {
  const Node* value = reader.node(key);
  if (!value) return std::nullopt;
  const auto refuse = [&](const std::string& finding) {
    reader.error(key, finding, "rows of two numbers are expected: [[x, y], …]", "check brackets and commas");
    return std::nullopt;
  };
  if (value->kind != Node::Kind::array) return refuse(kind_name(value->kind));
  if (value->items.size() < 2) return refuse(fmt::format("{} rows", value->items.size()));
  Eigen::MatrixXd pairs(to_index(value->items.size()), 2);
  const std::size_t before = reader.errors();
  for (std::size_t i = 0; i < value->items.size(); ++i) {
    const Node& row = value->items[i];
    if (row.kind != Node::Kind::array || row.items.size() != 2)
      return refuse(fmt::format(
          "row {} is {}", i + 1,
          row.kind == Node::Kind::array ? fmt::format("of {} numbers", row.items.size()) : kind_name(row.kind)));
    for (std::size_t j = 0; j < 2; ++j)
      pairs(to_index(i), to_index(j)) =
          read_cell(reader, row.items[j], fmt::format("{}.{}[{}][{}]", reader.path(), key, i, j), j == 0 ? x : y)
              .value_or(0);
  }
  if (reader.errors() == before)
    for (const std::size_t j : {0, 1}) check_mixed_units(reader, key, *value, j, j == 0 ? x : y);
  const bool own_units =
      std::ranges::any_of(value->items, [](const Node& row) { return row.items[1].kind == Node::Kind::text; });
  if (reader.errors() == before && own_units && reader.has("unit"))
    warn_at_key(reader, "unit", "beside rows with units of their own", "the units of the rows hold",
                "remove it, or the units of the rows");
  return reader.errors() == before ? std::optional(pairs) : std::nullopt;
}

ColumnQuantity read_bare_unit(TableReader& reader, ColumnQuantity column) {
  const auto unit = reader.text("unit");
  if (!unit || *unit == "SI") return column;
  const auto one = in_column_unit("1 " + *unit, column);
  if (!one) {
    reader.error("unit", foundation::quoted(*unit), one.error(),
                 other_motion_advice("1 " + split_level(*unit).number, column.quantity, reader.path(), column.density) +
                     "name a unit that converts to " + column.unit() + ", or leave it out for SI");
    return column;
  }
  column.bare *= *one;
  column.bare_unit = *unit;
  return column;
}

std::optional<Eigen::MatrixXd> read_pairs_of_file(TableReader& reader, const std::string& x, const std::string& y,
                                                  const ColumnQuantity& x_quantity, const ColumnQuantity& y_quantity,
                                                  std::size_t most_rows) {
  const auto file = read_file_name(reader, "file");
  std::string x_name = reader.text(x).value_or(x), y_name = reader.text(y).value_or(y);
  if (!file) return std::nullopt;
  auto csv = read_csv_table(*file, most_rows, {x_name, y_name});
  reader.add_of_file("file", csv ? csv->warnings : csv.error());
  if (!csv) return std::nullopt;
  for (std::string* name : {&x_name, &y_name}) {
    const UnitHeading heading = unit_heading(*name);
    if (const std::string unit = split_level(heading.unit).number; !unit.empty() && unit_ratio(unit, unit))
      *name = heading.name;
  }
  foundation::Problems wrong_units;
  const std::set<std::string> with_units = convert_columns(
      *csv,
      [&](const std::string& name) {
        return name == x_name ? std::optional(x_quantity) : name == y_name ? std::optional(y_quantity) : std::nullopt;
      },
      wrong_units);
  reader.add_of_file("file", wrong_units);
  if (wrong_units.has_errors()) return std::nullopt;
  if (reader.has("unit") && with_units.contains(y_name))
    warn_at_key(reader, "unit", "of a column that has its unit in the heading", "the unit in the heading holds",
                "remove one of them");
  const auto values = columns(*csv, {x_name, y_name});
  if (!values) {
    foundation::Problems missing = values.error();
    for (foundation::Problem& problem : missing.list())
      for (const std::string* key : {&x, &y})
        if (!reader.has(*key) && problem.finding == "no column " + *key)
          problem.remedy = fmt::format("name the one that is meant: {} = \"COLUMN\", or rename it to {}", *key, *key);
    reader.add_of_file("file", missing);
    return std::nullopt;
  }
  if (!reader.has(y) && csv->columns.size() > 2) {
    std::string others;
    for (const std::string& column : csv->columns)
      if (column != x_name && column != y_name) others += (others.empty() ? "" : ", ") + foundation::quoted(column);
    warn_at_key(reader, "file", "column" + std::string(csv->columns.size() > 3 ? "s " : " ") + others + " not used",
                "one column is read in addition to " + x_name,
                "name it: " + y + " = \"" + y_name + "\", or remove the others");
  }
  foundation::Problems holes;
  constexpr std::size_t most = 20;
  for (Eigen::Index i = 0; i < values->rows() && holes.list().size() < most; ++i)
    if (!values->row(i).allFinite()) {
      foundation::Problem& problem =
          holes.error("", fmt::format("{} = {:.6g}, {} = {:.6g}", x_name, (*values)(i, 0), y_name, (*values)(i, 1)),
                      "every cell must hold a finite number", "complete or remove the row");
      problem.origin = {csv->source, csv->lines[i]};
    }
  reader.add_of_file("file", holes);
  return holes.has_errors() ? std::nullopt : std::optional(*values);
}

}  // namespace trivet::project
