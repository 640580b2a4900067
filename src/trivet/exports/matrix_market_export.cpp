// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/documents/csv_field.h"
#include "trivet/exports/format_table.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/format/in_documents.h"

/// Matrices as coordinate files of Matrix Market, and the names of their rows.
namespace trivet::exports {
namespace {

using results::LabelledArray;

std::string matrix_market(const LabelledArray& array, const std::string& words) {
  const std::vector<double> numbers = array.real_numbers();
  const std::size_t rows = array.shape[0], columns = array.shape[1];
  std::string entries;
  std::size_t count = 0;
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t i = 0; i < rows; ++i)
      if (const double value = numbers[i * columns + j]; value != 0) {
        entries += fmt::format("{} {} {}\n", i + 1, j + 1, value);
        ++count;
      }
  return fmt::format(
      "%%MatrixMarket matrix coordinate real general\n% {} of {}; SI; rows in coordinates.csv\n{} {} {}\n{}",
      array.name, words, rows, columns, count, entries);
}

std::vector<std::string> write_matrix_market(const Content& content, const Target& target,
                                             const foundation::Progress&) {
  const Group* matrices = content.find("matrices");
  for (const char* name : {"A", "B", "K", "K_loss"})
    write_bytes(target.path() / (std::string(name) + ".mtx"),
                matrix_market(*matrices->arrays.find(name), content.words()));
  const std::vector<std::string>&names = matrices->arrays.find("coordinate")->texts(),
        &units = matrices->arrays.find("coordinate_unit")->texts();
  std::string rows = "row,coordinate,unit\n";
  for (std::size_t i = 0; i < names.size(); ++i)
    rows += fmt::format("{},{},{}\n", i + 1, results::csv_field(names[i]), units[i]);
  write_bytes(target.path() / "coordinates.csv", rows);
  return {loads_left_out};
}

}  // namespace

const Format matrix_market_format = {"matrix_market",
                                     "folder of A.mtx, B.mtx, K.mtx, K_loss.mtx and coordinates.csv",
                                     Target::Kind::folder,
                                     {"matrices"},
                                     false,
                                     write_matrix_market};

}  // namespace trivet::exports
