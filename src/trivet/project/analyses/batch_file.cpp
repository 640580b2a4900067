// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/batch_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/project/text/column_units.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

/// Gaps, each at its line.
foundation::Problems gaps_in(const CsvTable& table) {
  foundation::Problems problems;
  for (std::size_t row = 0; row < table.lines.size(); ++row)
    if (!std::isfinite(table.values(to_index(row), 0)))
      problems.error(table.columns.front(), "no number in this row", "a measured batch has no gaps", "remove the row")
          .origin = {table.source, table.lines[row], 0};
  return problems;
}

foundation::Problems problem_of_file(const CsvTable& table, int line, std::string finding, std::string rule,
                                     std::string remedy) {
  foundation::Problems problems;
  problems.error(table.columns.front(), std::move(finding), std::move(rule), std::move(remedy)).origin = {table.source,
                                                                                                          line, 0};
  return problems;
}

}  // namespace

std::optional<std::vector<double>> read_batch_file(TableReader& reader, const std::optional<Quantity>& quantity) {
  const auto file = read_file_name(reader, "file");
  if (!file) return std::nullopt;
  auto csv = read_csv_table(*file);
  reader.add_of_file("file", csv ? csv->warnings : csv.error());
  if (!csv) return std::nullopt;
  const auto refuse = [&](const foundation::Problems& problems) {
    reader.add_of_file("file", problems);
    return std::nullopt;
  };
  if (csv->columns.size() != 1)
    return refuse(problem_of_file(
        *csv, 1, fmt::format("{} columns: {}", csv->columns.size(), fmt::join(csv->columns, ", ")),
        "a measured batch is one column, the numbers in one unit", "keep the column of this tolerance"));
  if (csv->lines.size() < fewest_measured)
    return refuse(problem_of_file(*csv, csv->lines.empty() ? 1 : csv->lines.back(),
                                  fmt::format("{} rows", csv->lines.size()),
                                  fmt::format("a distribution needs at least {} measured numbers", fewest_measured),
                                  "measure more, or give half_width or standard_deviation"));
  if (const foundation::Problems gaps = gaps_in(*csv); gaps.has_errors()) return refuse(gaps);
  foundation::Problems wrong_units;
  convert_columns(
      *csv, [&](const std::string&) { return quantity ? std::optional(ColumnQuantity(*quantity)) : std::nullopt; },
      wrong_units);
  if (wrong_units.has_errors()) return refuse(wrong_units);
  const auto values = csv->values.col(0);
  if (values.minCoeff() == values.maxCoeff())
    return refuse(problem_of_file(*csv, csv->lines.front(), fmt::format("{:.6g} in every row", values(0)),
                                  "a batch has different numbers", "check the file"));
  return std::vector<double>(values.begin(), values.end());
}

}  // namespace trivet::project
