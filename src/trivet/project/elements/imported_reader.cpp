// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "trivet/exchange/end_stiffness.h"
#include "trivet/exchange/matrix_file.h"
#include "trivet/model/system.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/matrix_table.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

/// Whole numbers from a list of the given length.
std::optional<std::vector<int>> whole_numbers(TableReader& reader, const char* key, std::size_t count) {
  const auto numbers = reader.numbers(key, Quantity::pure);
  if (!numbers) return std::nullopt;
  std::vector<int> whole;
  for (const double number : *numbers)
    if (number >= 0 && number < 2e9 && number == std::floor(number)) whole.push_back(static_cast<int>(number));
  if (whole.size() == count && numbers->size() == count) return whole;
  if (numbers->size() == count) {
    reader.error(key, "a number that is negative or not whole", fmt::format("{} whole numbers are expected", count),
                 "use the node numbers of the file; rows count from 1");
    return std::nullopt;
  }
  reader.error(key, fmt::format("{} values", numbers->size()), fmt::format("{} whole numbers are expected", count),
               "use the node numbers of the file; rows count from 1");
  return std::nullopt;
}

/// 12×12 from two named nodes, twelve rows, or the whole matrix of the file.
foundation::Expected<exchange::EndMatrix> reduced(TableReader& reader, const exchange::NamedMatrix& matrix) {
  const std::size_t before = reader.errors();
  const auto nodes = whole_numbers(reader, "nodes", 2), turning = whole_numbers(reader, "rotation_nodes", 2);
  const auto given = whole_numbers(reader, "rows", 12);
  if (reader.has("nodes") && reader.has("rows"))
    reader.error("rows", "nodes and rows", "only one of them names the ends", "keep one of them");
  if (reader.has("rotation_nodes") && !reader.has("nodes"))
    reader.error("rotation_nodes", "rotation_nodes without nodes", "they have the rotations of the ends in `nodes`",
                 "add nodes = [N, K], or remove it");
  if (reader.errors() > before) return tl::make_unexpected(foundation::Problems());
  if (nodes) {
    const exchange::NodeEnd n{(*nodes)[0], turning ? (*turning)[0] : 0}, k{(*nodes)[1], turning ? (*turning)[1] : 0};
    return exchange::reduce_to_ends(matrix, n, k);
  }
  std::array<int, 12> rows = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  if (given) {
    std::ranges::copy(*given, rows.begin());
  } else if (matrix.values.rows() != 12) {
    foundation::Problems problems;
    problems.error("file", fmt::format("{} × {}", matrix.values.rows(), matrix.values.cols()),
                   "an element has 12 × 12; a larger matrix is condensed onto its two ends",
                   "name them: nodes = [N, K], or rows = [six of N, six of K]");
    return tl::make_unexpected(std::move(problems));
  }
  return exchange::reduce_to_rows(matrix, rows);
}

void warn_of_fixed_components(TableReader& reader, const exchange::Matrix12& values, const std::vector<int>& fixed) {
  std::string names;
  for (const int row : fixed)
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", row < 6 ? "N" : "K", model::coordinate_names[row % 6]);
  foundation::Problems found;
  found.warning(
      "", fmt::format("{:.3g} on the diagonal for the components {}", values(fixed.front(), fixed.front()), names),
      "such a number stands for a component that a boundary condition fixes, as Abaqus writes it (1e36)",
      "replaced by the stiffness with which a rigid motion needs no force; write the matrix without boundary "
      "conditions to be independent of it");
  reader.add_of_file("file", found);
}

void read_imported(TableReader& reader, Placement& placement, model::Element& element) {
  const auto file = read_file_name(reader, "file");
  exchange::MatrixFileOptions options;
  options.format = reader.choice("format", exchange::matrix_formats()).value_or("");
  options.name = reader.text("name").value_or("");
  const double length_unit = reader.has("length_unit") ? reader.number("length_unit", Quantity::length).value_or(1) : 1;
  const double force_unit = reader.has("force_unit") ? reader.number("force_unit", Quantity::force).value_or(1) : 1;
  for (const auto& [key, unit] : {std::pair{"length_unit", length_unit}, std::pair{"force_unit", force_unit}})
    if (!(unit > 0)) reader.error(key, fmt::format("{:.6g}", unit), "a unit is > 0", "write \"mm\" as \"1 mm\"");
  if (!file || !(length_unit > 0) || !(force_unit > 0)) {
    for (const char* key : {"nodes", "rotation_nodes", "rows"}) static_cast<void>(reader.node(key));
    return;
  }
  const auto matrix = exchange::read_matrix_file(*file, options);
  if (!matrix) {
    for (const char* key : {"nodes", "rotation_nodes", "rows"}) static_cast<void>(reader.node(key));
    reader.add_of_file("file", matrix.error());
    return;
  }
  reader.add_of_file("file", matrix->warnings);
  const auto ends = reduced(reader, *matrix);
  const char* named = reader.has("rows") ? "rows" : reader.has("nodes") ? "nodes" : "file";
  const TableReader::Names names = {{"end N", named}, {"end K", named}, {"ends", named}, {"condensation", named}};
  if (!ends) {
    reader.add(ends.error(), names);
    return;
  }
  reader.add(ends->warnings, names);
  elements::Matrix12 stiffness = exchange::in_si(ends->values, length_unit, force_unit);
  if (const std::vector<int> fixed = exchange::fixed_components(ends->values); !fixed.empty()) {
    stiffness = exchange::completed_by_rigid_motion(
        stiffness, fixed, elements::rigid_motions(placement.span.arm, Eigen::Matrix3d::Identity()));
    warn_of_fixed_components(reader, ends->values, fixed);
  }
  element.law.nominal_stiffness = elements::in_end_axes(stiffness, placement.span.n_from_k);
  if (ends->imaginary)
    set_loss(reader,
             elements::in_end_axes(exchange::in_si(*ends->imaginary, length_unit, force_unit), placement.span.n_from_k),
             placement.span, element);
  element.facts.push_back(
      {"found in", file->filename().string() + fmt::format(", {} × {}", matrix->values.rows(), matrix->values.cols())});
}

}  // namespace

const ElementLaw imported_law = {.type = "imported", .placed = read_imported, .keys = R"json({"properties": {
   "file": {"type": "string", "description": "relative to the project file"},
   "format": {"enum": ["matrix_market", "numpy", "csv", "nastran", "abaqus", "calculix"],
     "description": "of the file (default: determined from the file)"},
   "name": {"type": "string", "description": "of one of several matrices in the file"},
   "length_unit": {"$ref": "#/$defs/number", "description": "length of 1 in the file, m (default: 1)"},
   "force_unit": {"$ref": "#/$defs/number", "description": "force of 1 in the file, N (default: 1)"},
   "nodes": {"type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": 2, "maxItems": 2,
     "description": "nodes of ends N and K; the others are condensed"},
   "rotation_nodes": {"type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": 2, "maxItems": 2,
     "description": "nodes that hold the rotations of the ends as components 1 to 3"},
   "rows": {"type": "array", "items": {"type": "integer", "minimum": 1}, "minItems": 12, "maxItems": 12,
     "description": "rows of ends N and K, from 1; instead of nodes"}},
  "required": ["file"],
  "not": {"required": ["nodes", "rows"]},
  "dependentRequired": {"rotation_nodes": ["nodes"]}})json"};

}  // namespace trivet::project
