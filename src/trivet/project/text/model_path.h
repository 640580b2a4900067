// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Keys of a dotted path of the project file: elements."front left".at.y → elements, front left, at, y. Empty if it is
/// not a path. Numbers of an array of three are its components x, y and z.
[[nodiscard]] std::vector<std::string> path_keys(const std::string& path);

/// Index of a component in an array of three numbers: 0 for "x". None for other arrays and words.
[[nodiscard]] std::optional<std::size_t> component_of(const Node& array, const std::string& word);

/// True for arrays of three that are 0 by default: their components can be changed without a written array.
[[nodiscard]] bool is_zero_by_default(const std::string& key);

/// The value at a path, if it exists.
[[nodiscard]] const Node* node_at(const Node& document, const std::vector<std::string>& keys);

/// The change "path = value" with a value in `unit`, as the file would have it.
[[nodiscard]] Node change_of(const std::vector<std::string>& keys, double value, const std::string& unit);

/// A value and its unit as written: "12 mm" → 12, "mm"; a bare number has the unit "". None if it is not a number.
struct WrittenNumber {
  double value = 0;
  std::string unit;
};
[[nodiscard]] std::optional<WrittenNumber> written_number(const Node& node);

/// True for a unit of any quantity, and for "" of a bare number.
[[nodiscard]] bool is_known_unit(const std::string& unit);

/// The number converted to another unit; an empty unit is SI. None if the units measure different quantities.
[[nodiscard]] std::optional<double> in_unit(const WrittenNumber& number, const std::string& unit);

}  // namespace trivet::project
