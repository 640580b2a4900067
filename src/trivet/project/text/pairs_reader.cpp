// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/pairs_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/file_name.h"
#include "trivet/project/text/idle_key.h"

namespace trivet::project {

std::optional<Eigen::MatrixXd> read_pairs(TableReader& reader, const std::string& key, Quantity x, Quantity y) {
  const Node* value = reader.node(key);
  if (!value) return std::nullopt;
  const auto refuse = [&](const std::string& finding) {
    reader.error(key, finding, "rows of two numbers are expected: [[x, y], …]", "check brackets and commas");
    return std::nullopt;
  };
  if (value->kind != Node::Kind::array) return refuse(kind_name(value->kind));
  if (value->items.size() < 2) return refuse(fmt::format("{} rows", value->items.size()));
  Eigen::MatrixXd pairs(to_index(value->items.size()), 2);
  bool good = true;
  for (std::size_t i = 0; i < value->items.size(); ++i) {
    const Node& row = value->items[i];
    if (row.kind != Node::Kind::array || row.items.size() != 2)
      return refuse(fmt::format(
          "row {} is {}", i + 1,
          row.kind == Node::Kind::array ? fmt::format("of {} numbers", row.items.size()) : kind_name(row.kind)));
    for (std::size_t j = 0; j < 2; ++j) {
      const auto entry =
          reader.scalar(row.items[j], fmt::format("{}.{}[{}][{}]", reader.path(), key, i, j), j == 0 ? x : y);
      good = good && entry;
      pairs(to_index(i), to_index(j)) = entry.value_or(0);
    }
  }
  return good ? std::optional(pairs) : std::nullopt;
}

std::optional<Eigen::MatrixXd> read_pairs_of_file(TableReader& reader, const std::string& x, const std::string& y,
                                                  std::size_t most_rows) {
  const auto file = read_file_name(reader, "file");
  const std::string x_name = reader.text(x).value_or(x), y_name = reader.text(y).value_or(y);
  if (!file) return std::nullopt;
  const auto csv = read_csv_table(*file, most_rows, {x_name, y_name});
  reader.add_of_file("file", csv ? csv->warnings : csv.error());
  if (!csv) return std::nullopt;
  const auto values = columns(*csv, {x_name, y_name});
  if (!values) {
    reader.add_of_file("file", values.error());
    return std::nullopt;
  }
  if (!reader.has(y) && csv->columns.size() > 2) {
    std::string others;
    for (const std::string& column : csv->columns)
      if (column != x_name && column != y_name) others += (others.empty() ? "" : ", ") + foundation::quoted(column);
    warn_of_idle_key(
        reader, "file", "column" + std::string(csv->columns.size() > 3 ? "s " : " ") + others + " not used",
        "one column is read in addition to " + x_name, "name it: " + y + " = \"" + y_name + "\", or remove the others");
  }
  foundation::Problems holes;
  constexpr std::size_t most = 20;
  for (Eigen::Index i = 0; i < values->rows() && holes.list().size() < most; ++i)
    if (!values->row(i).allFinite()) {
      foundation::Problem& problem =
          holes.error("", fmt::format("{} = {:.6g}, {} = {:.6g}", x_name, (*values)(i, 0), y_name, (*values)(i, 1)),
                      "every cell must hold a finite number", "complete or remove the row");
      problem.origin = {csv->source, csv->lines[to_size(i)]};
    }
  reader.add_of_file("file", holes);
  return holes.has_errors() ? std::nullopt : std::optional(*values);
}

}  // namespace trivet::project
