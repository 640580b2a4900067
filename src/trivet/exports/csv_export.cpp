// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/documents/csv_field.h"
#include "trivet/exports/format_table.h"
#include "trivet/exports/part_tables.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/format/written_results.h"

/// The tables of the result folder, and the parts of the model as tables that a project file reads.
namespace trivet::exports {
namespace {

/// A matrix with the names of its rows and columns, SI.
std::string matrix_csv(const results::LabelledArray& matrix, const results::LabelledArrays& all) {
  const std::vector<std::string>&names = all.find("coordinate")->texts(), &units = all.find("coordinate_unit")->texts();
  const std::vector<double> numbers = matrix.real_numbers();
  std::string text = "coordinate,unit";
  for (const std::string& name : names) text += "," + results::csv_field(name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("\n{},{}", results::csv_field(names[i]), units[i]);
    for (std::size_t j = 0; j < names.size(); ++j) text += fmt::format(",{}", numbers[i * names.size() + j]);
  }
  return text + "\n";
}

std::vector<std::string> write_csv(const Content& content, const Target& target, const foundation::Progress&) {
  std::vector<std::string> lost;
  for (const PartTable& table : part_tables(content.variant.document, lost))
    write_bytes(target.path() / (table.kind + ".csv"), table.csv);
  for (const Group& group : content.groups) {
    if (!group.results) {
      for (const char* name : {"A", "B", "K", "K_loss"})
        write_bytes(target.path() / (std::string(name) + ".csv"), matrix_csv(*group.arrays.find(name), group.arrays));
      lost.emplace_back(loads_left_out);
      continue;
    }
    for (const results::ResultTable& table : results::result_tables(group.name))
      if (!table.is_in || table.is_in(*group.results))
        write_bytes(target.path() / table.file, table.csv(content.variant, *group.results));
  }
  return lost;
}

}  // namespace

const Format csv_format = {
    "csv",
    "folder with the CSV tables of the results, the matrices, and bodies, elements and points as tables for a file",
    Target::Kind::folder,
    {},
    false,
    write_csv};

}  // namespace trivet::exports
