// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

// Headers and cells of a table as keys and values of the project file.

[[nodiscard]] Node text_node(std::string text, const foundation::Origin& origin);

[[nodiscard]] Node table_node(const foundation::Origin& origin);

/// "at.x [mm]" → the keys at, x and the unit mm.
struct Column {
  std::vector<std::string> keys;
  std::string unit;
};

/// Keys and unit of a header; empty if it is not a key with its unit in brackets.
[[nodiscard]] std::optional<Column> column_of(const std::string& header);

/// The number that the whole cell is, empty otherwise.
[[nodiscard]] std::optional<double> number_of(const std::string& cell);

/// A cell as a value of the project file: a number with the unit of its column, true or false, or a text.
[[nodiscard]] Node cell_node(const std::string& cell, const std::string& unit, const foundation::Origin& origin);

/// Sets a value under nested keys; missing tables are created.
void put(Node& table, const std::vector<std::string>& keys, Node value);

/// Combines columns such as at.x, at.y, at.z of a row into one array; a missing component is a problem.
/// @param path  of the row in the project file, for messages
void combine_components(Node& row, const std::string& path, foundation::Problems& problems);

// `[tables.elements]`, `[tables.bodies]`, `[tables.points]`: many parts at once, one per row (docs/project-file.md,
// "Tables of bodies and elements").

/// Inserts the rows of these tables into the elements, bodies and points of the document, as if each had a separate
/// table, and removes the key `tables`. Problems of a row name its line.
void put_tables_in_place(Node& document, foundation::Problems& problems);

/// Merges the same problem of a column in several rows into one, at the first row.
void gather_columns(foundation::Problems& problems);

}  // namespace trivet::project
