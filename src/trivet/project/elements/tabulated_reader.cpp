// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <set>

#include "trivet/elements/stiffness_over_deflection.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/law_readers.h"
#include "trivet/project/elements/matrix_table.h"
#include "trivet/project/elements/stiffness_column.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

constexpr std::array<const char*, 6> directions = {"x", "y", "z", "rx", "ry", "rz"};

}  // namespace

void read_tabulated(TableReader& reader, Placement& ends, model::Element& element) {
  const std::size_t before = reader.errors();
  const double centre = reader.number("center", Quantity::pure).value_or(0.5);
  const auto interpolation = reader.choice("interpolation", {"monotone_cubic", "linear"}) == "linear"
      ? elements::Interpolation::linear
      : elements::Interpolation::monotone_cubic;
  const auto file = read_file_name(reader, "file");
  if (reader.has("damping"))
    reader.error("damping", "damping together with a table", "its table holds the loss", "remove it");
  static_cast<void>(reader.node("damping"));
  if (!(centre >= 0 && centre <= 1))
    reader.error("center", fmt::format("{:.6g}", centre), "the elastic centre is between the ends: 0 (N) … 1 (K)",
                 "give a fraction of the length");
  if (!file) return;
  auto csv = read_csv_table(*file, most_rows_over_frequency);
  if (!csv) {
    reader.add_of_file("file", csv.error());
    return;
  }
  reader.add_of_file("file", csv->warnings);
  foundation::Problems wrong_units;
  convert_columns(*csv, stiffness_column_quantity, wrong_units);
  if (wrong_units.has_errors()) {
    reader.add_of_file("file", wrong_units);
    return;
  }
  if (is_matrix_table(*csv)) {
    for (const char* key : {"center", "interpolation"})
      if (reader.has(key))
        reader.error(key, std::string(key) + " together with a table of matrices",
                     "a matrix has no center, and is interpolated linearly so that it stays passive", "remove it");
    if (reader.errors() == before) read_matrix_table(reader, *csv, ends.span, element);
    return;
  }
  auto law = std::make_shared<std::array<std::optional<elements::PiecewiseStiffness>, 6>>();
  elements::Vector6 static_constants = elements::Vector6::Zero();
  std::set<std::string> wanted = {"frequency_hz"};
  double from = 0, to = 0;
  std::vector<double> knots;
  for (int j = 0; j < 6; ++j) {
    const std::string name = std::string("k_") + directions[j];
    if (std::ranges::find(csv->columns, name) == csv->columns.end()) continue;
    wanted.insert({name, name + "_loss"});
    const auto values = columns(*csv, {"frequency_hz", name, name + "_loss"});
    if (!values) {
      reader.add_of_file("file", values.error());
      continue;
    }
    const auto checked = checked_table(reader, name, *values, interpolation);
    if (!checked) continue;
    const elements::StiffnessTable& table = *checked;
    judge_causality(reader, name, table, element);
    (*law)[j].emplace(table);
    static_constants(j) = table.storage(0, 0);
    knots = table.angular_frequencies;
    from = knots.front();
    to = knots.back();
  }
  for (const std::string& column : csv->columns)
    if (!wanted.contains(column))
      reader.error("file", "column " + foundation::quoted(column),
                   "columns are frequency_hz and, per direction, k_x and k_x_loss (y, z, rx, ry, rz)",
                   "rename or remove it");
  if (wanted.size() == 1) {
    reader.error("file", "no stiffness column",
                 "columns are frequency_hz and, per direction, k_x and k_x_loss (y, z, rx, ry, rz)",
                 "add at least one pair");
    return;
  }
  if (reader.errors() > before) return;
  element.law.nominal_stiffness =
      elements::in_end_axes(elements::constants_at_point(static_constants, ends.span.arm, centre), ends.span.n_from_k);
  std::array<elements::Matrix12, 6> unit;
  for (int j = 0; j < 6; ++j)
    unit[j] = elements::in_end_axes(elements::constants_at_point(elements::Vector6::Unit(j), ends.span.arm, centre),
                                    ends.span.n_from_k);
  elements::FrequencyDependence dependence;
  dependence.elastic = false;
  dependence.from = from;
  dependence.to = to;
  dependence.knots = knots;
  dependence.stiffness = [law, unit](std::complex<double> omega, double near) {
    elements::Matrix12c sum = elements::Matrix12c::Zero();
    for (std::size_t j = 0; j < 6; ++j)
      if ((*law)[j]) sum += (*law)[j]->at(omega, near) * unit[j].cast<std::complex<double>>();
    return sum;
  };
  element.law.frequency_dependence = std::move(dependence);
  element.facts.push_back(defined_range(from, to));
}

namespace {

/// A table, or a column of gas along e3 that is compressed as K approaches N.
void read_air_spring(TableReader& reader, Placement& ends, model::Element& element) {
  const bool is_gas = reader.has("pressure") || reader.has("volume") || reader.has("area");
  if (!is_gas) return read_tabulated(reader, ends, element);
  for (const char* key : {"file", "interpolation", "center", "damping"}) {
    if (reader.has(key))
      reader.error(key, std::string(key) + " beside a gas law", "an air spring is a table or a gas law",
                   "remove it; a damper beside it damps");
    static_cast<void>(reader.node(key));
  }
  constexpr double middle = 0.5;
  constexpr int along = 2;
  const double lateral = reader.number("lateral", Quantity::force_per_length).value_or(0);
  if (!(lateral >= 0)) reader.error("lateral", fmt::format("{:.6g} N/m", lateral), "it is ≥ 0", "correct its sign");
  elements::Vector6 constants = elements::Vector6::Zero();
  constants.head<2>().setConstant(lateral);
  element.law.nominal_stiffness =
      elements::in_end_axes(elements::constants_at_point(constants, ends.span.arm, middle), ends.span.n_from_k);
  if (const auto gas = read_gas_force(reader))
    element.nonlinear_parts.push_back({along, middle, {elements::ElasticForce(*gas)}});
}

}  // namespace

const ElementLaw table_law = {
    .type = "table",
    .placed = read_tabulated,
    .keys =
        R"json({"properties": {
   "file": {"type": "string",
     "description": "CSV relative to the project file: frequency_hz and, per direction x, y, z, rx, ry, rz, k_x )json"
        R"json(and k_x_loss (N/m or N m/rad); or a whole matrix, per entry k_I_J and k_I_J_loss, I ≤ J, up to 6 (moved )json"
        R"json(end K) or 12 (N, then K)"},
   "interpolation": {"enum": ["monotone_cubic", "linear"],
     "description": "default: monotone_cubic; a whole matrix is interpolated linearly"},
   "center": {"$ref": "#/$defs/number",
     "description": "elastic centre as a fraction of the length from N, 0 to 1 (default: 0.5)"},
   "damping": false},
  "required": ["file"]})json"};
const ElementLaw air_spring_law = {.type = "air_spring", .placed = read_air_spring, .keys = R"json([
   {"properties": {
   "file": {"type": "string", "description": "CSV as of a table"},
   "interpolation": {"enum": ["monotone_cubic", "linear"],
     "description": "between the rows (default: monotone_cubic)"},
   "center": {"$ref": "#/$defs/number",
     "description": "elastic centre as a fraction of the length from N, 0 to 1 (default: 0.5)"},
   "damping": false},
   "required": ["file"]},
   {"properties": {
   "pressure": {"$ref": "#/$defs/number", "description": "absolute, Pa, at the length where the ends are, > 0"},
   "volume": {"$ref": "#/$defs/number", "description": "of the gas there, m^3, > 0"},
   "area": {"$ref": "#/$defs/number", "description": "effective, m^2, > 0"},
   "exponent": {"$ref": "#/$defs/number", "description": "polytropic, 1 to 2 (default: 1.4)"},
   "atmosphere": {"$ref": "#/$defs/number", "description": "Pa: absolute pressure outside (default: 101325)"},
   "lateral": {"$ref": "#/$defs/number", "description": "stiffness across the axis, N/m (default: 0)"},
   "damping": false},
   "required": ["pressure", "volume", "area"]}])json"};

}  // namespace trivet::project
