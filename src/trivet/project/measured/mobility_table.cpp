// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/measured/mobility_reader.h"
#include "trivet/project/text/column_units.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

constexpr const char* mobility_columns =
    "columns are frequency_hz and, per entry, y_I_J and y_I_J_im with I, J out of x, y, z, rx, ry, rz (the upper "
    "triangle), in SI or with a unit: y_z_z [(mm/s)/N]";

std::string mobility_column(int i, int j) {
  return fmt::format("y_{}_{}", model::coordinate_names[i], model::coordinate_names[j]);
}

std::optional<std::pair<int, int>> entry_of(std::string name) {
  if (name.ends_with("_im")) name.resize(name.size() - 3);
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      if (name == mobility_column(i, j)) return std::pair(i, j);
  return std::nullopt;
}

/// SI unit of an entry. A motion per moment has that of a rotation per force.
const char* unit_of_entry(const std::pair<int, int>& entry) {
  const int rotations = (entry.first > 2) + (entry.second > 2);
  return rotations == 0 ? "(m/s)/N" : rotations == 1 ? "(rad/s)/N" : "(rad/s)/(N m)";
}

/// Converts columns whose headings have a unit, "y_z_z [(mm/s)/N]", to SI, and removes it.
void convert_mobilities(CsvTable& table, foundation::Problems& found) {
  const auto error = [&](const std::string& finding, std::string rule, std::string remedy) {
    found.error("", finding, std::move(rule), std::move(remedy)).origin = {table.source, 0, 0};
  };
  convert_columns(
      table, [](const std::string& name) { return name == "frequency_hz" ? std::optional(in_hertz()) : std::nullopt; },
      found);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const UnitHeading heading = unit_heading(table.columns[c]);
    const auto entry = heading.unit.empty() ? std::nullopt : entry_of(heading.name);
    if (!entry) continue;
    const std::string column = "column " + foundation::quoted(table.columns[c]), si = unit_of_entry(*entry);
    const auto ratio = unit_ratio(heading.unit, si);
    if (!ratio) error(column, "its unit is not one of a velocity per force", "write a unit that converts to " + si);
    else table.values.col(to_index(c)) *= *ratio;
    if (std::ranges::find(table.columns, heading.name) != table.columns.end())
      error(column + ": another column is " + foundation::quoted(heading.name),
            "every column has a different name without its unit", "remove or rename one");
    table.columns[c] = heading.name;
  }
}

void check_frequencies(const CsvTable& csv, const Eigen::VectorXd& frequency, foundation::Problems& found) {
  for (Eigen::Index i = 0; i < frequency.size(); ++i) {
    const bool rises = i == 0 || frequency(i) > frequency(i - 1);
    if (frequency(i) > 0 && rises) continue;
    found
        .error("", fmt::format("frequency_hz = {:.6g}", frequency(i)),
               rises ? "a mobility is measured above 0 Hz" : "frequencies increase from row to row",
               "sort or correct the rows")
        .origin = {csv.source, csv.lines[i]};
  }
  if (frequency.size() < 2)
    found.error("", fmt::format("{} rows", frequency.size()), "a table has at least two rows", "add some");
}

}  // namespace

std::optional<GroundMobility> read_mobility_table(TableReader& reader) {
  const std::size_t before = reader.errors();
  const auto file = read_file_name(reader, "file");
  if (!file) return std::nullopt;
  auto csv = read_csv_table(*file, most_rows_over_frequency);
  reader.add_of_file("file", csv ? csv->warnings : csv.error());
  if (!csv) return std::nullopt;
  foundation::Problems wrong_units;
  convert_mobilities(*csv, wrong_units);
  reader.add_of_file("file", wrong_units);
  if (wrong_units.has_errors()) return std::nullopt;
  std::vector<std::pair<int, int>> entries;
  for (const std::string& column : csv->columns) {
    const auto entry = entry_of(column);
    if (!entry && column != "frequency_hz")
      reader.error("file", "column " + foundation::quoted(column), mobility_columns, "rename or remove it");
    if (entry && !column.ends_with("_im")) entries.push_back(*entry);
  }
  GroundMobility result;
  result.source = csv->source;
  result.lines = csv->lines;
  for (const auto& [i, j] : entries)
    if (i == j) result.directions.push_back({0, i, mobility_column(i, i)});
  const auto place = [&](int coordinate) {
    return std::ranges::find(result.directions, coordinate, &GroundMobility::Direction::coordinate) -
        result.directions.begin();
  };
  for (const auto& [i, j] : entries)
    if (place(i) == std::ssize(result.directions) || place(j) == std::ssize(result.directions))
      reader.error("file", mobility_column(i, j) + " without the diagonal",
                   "a coupling needs the diagonal mobilities of both directions", "add them");
  if (entries.empty()) reader.error("file", "no mobility column", mobility_columns, "add at least one pair");
  if (reader.errors() > before) return std::nullopt;
  const auto count = to_index(result.directions.size());
  result.rows.assign(to_size(csv->values.rows()), Eigen::MatrixXcd::Zero(count, count));
  foundation::Problems found;
  for (const auto& [i, j] : entries) {
    const std::string name = mobility_column(i, j);
    const auto values = columns(*csv, {"frequency_hz", name, name + "_im"});
    if (!values) return reader.add_of_file("file", values.error()), std::nullopt;
    if (result.knots.empty()) check_frequencies(*csv, values->col(0), found);
    result.knots.assign(values->col(0).begin(), values->col(0).end());
    for (Eigen::Index r = 0; r < values->rows(); ++r) {
      if (!values->row(r).allFinite())
        found.error("", name + " is missing", "every cell must hold a finite number", "complete or remove the row")
            .origin = {csv->source, csv->lines[r]};
      result.rows[r](place(i), place(j)) = result.rows[r](place(j), place(i)) =
          std::complex<double>((*values)(r, 1), (*values)(r, 2));
    }
  }
  for (double& frequency : result.knots) frequency *= foundation::two_pi;
  if (!found.has_errors()) found.add(judge_mobility(result));
  reader.add_of_file("file", found);
  if (found.has_errors()) return std::nullopt;
  return result;
}

}  // namespace trivet::project
