// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/loop_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/column_units.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {

using identification::LoopFit;
using identification::LoopRecord;

void add_loop_problems(TableReader& reader, const foundation::Problems& problems) {
  for (foundation::Problem problem : problems.list()) {
    if (problem.origin.line == 0) problem.origin = reader.node("loops")->origin;
    problem.subject = reader.path() + ".loops" + (problem.subject.empty() ? "" : " (" + problem.subject + ")");
    reader.problems().add(std::move(problem));
  }
}

namespace {

/// One record for each run of rows with the same `loop`: displacement and force in the given units; frequency_hz and
/// time if these columns exist.
std::vector<LoopRecord> records(const CsvTable& table, const Eigen::MatrixXd& needed, double length_unit,
                                double force_unit) {
  const auto column = [&](const char* name) -> Eigen::Index {
    const auto found = std::ranges::find(table.columns, name);
    return found == table.columns.end() ? -1 : found - table.columns.begin();
  };
  const Eigen::Index time = column("time"), frequency = column("frequency_hz");
  std::vector<LoopRecord> result;
  for (Eigen::Index first = 0; first < needed.rows();) {
    Eigen::Index count = 1;
    while (first + count < needed.rows() && needed(first + count, 0) == needed(first, 0)) ++count;
    LoopRecord record;
    record.name = fmt::format("loop {:.6g}", needed(first, 0));
    record.displacement = length_unit * needed.col(1).segment(first, count);
    record.force = force_unit * needed.col(2).segment(first, count);
    if (time >= 0) record.time = table.values.col(time).segment(first, count);
    if (frequency >= 0) record.angular_frequency = 2 * std::numbers::pi * table.values(first, frequency);
    result.push_back(std::move(record));
    first += count;
  }
  return result;
}

}  // namespace

std::optional<std::vector<LoopFit>> read_loop_file(TableReader& reader) {
  const std::size_t before = reader.errors();
  const auto file = read_file_name(reader, "loops");
  const double length_unit = reader.number("length_unit", Quantity::length).value_or(1),
               force_unit = reader.number("force_unit", Quantity::force).value_or(1);
  for (const auto& [key, unit] : {std::pair{"length_unit", length_unit}, std::pair{"force_unit", force_unit}})
    if (!(unit > 0)) reader.error(key, fmt::format("{:.6g}", unit), "a unit is > 0", "write \"1 mm\", \"1 kN\"");
  if (!file || reader.errors() > before) return std::nullopt;
  auto table = read_csv_table(*file);
  if (!table) {
    reader.add_of_file("loops", table.error());
    return std::nullopt;
  }
  reader.add_of_file("loops", table->warnings);
  foundation::Problems wrong_units;
  convert_columns(
      *table,
      [&](const std::string& name) -> std::optional<ColumnQuantity> {
        if (name == "displacement") return ColumnQuantity(Quantity::length, length_unit, "");
        if (name == "force") return ColumnQuantity(Quantity::force, force_unit, "");
        if (name == "time") return Quantity::time;
        if (name == "frequency_hz") return in_hertz();
        return std::nullopt;
      },
      wrong_units);
  reader.add_of_file("loops", wrong_units);
  for (const std::string& name : table->columns)
    if (name != "loop" && name != "displacement" && name != "force" && name != "time" && name != "frequency_hz")
      reader.error("loops", "column " + foundation::quoted(name),
                   "columns are loop, displacement, force, and time, frequency_hz if they are known",
                   "rename or remove it");
  const auto needed = columns(*table, {"loop", "displacement", "force"});
  if (!needed) {
    add_loop_problems(reader, needed.error());
    return std::nullopt;
  }
  if (reader.errors() > before) return std::nullopt;
  std::vector<LoopFit> loops;
  for (const LoopRecord& record : records(*table, *needed, length_unit, force_unit)) {
    const auto fit = identification::loop_fit(record);
    if (!fit) {
      foundation::Problems named = fit.error();
      for (foundation::Problem& problem : named.list())
        problem.subject = record.name + (problem.subject.empty() ? "" : ", " + problem.subject);
      add_loop_problems(reader, named);
      return std::nullopt;
    }
    add_loop_problems(reader, fit->warnings);
    loops.push_back(*fit);
  }
  return loops;
}

}  // namespace trivet::project
