// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::exports {

/// A table of parts as the project file reads it: `file = "elements.csv"` in [tables.elements].
struct PartTable {
  std::string kind;  ///< "bodies", "nodes", "elements", "points"
  std::string csv;
};

/// Bodies, nodes, elements and points of a model, one per row, with units in the headings where all rows have them.
/// @param document  the model with its element types merged in
/// @param lost      parts that a row cannot hold (a matrix), each with the key
[[nodiscard]] std::vector<PartTable> part_tables(const project::Node& document, std::vector<std::string>& lost);

}  // namespace trivet::exports
