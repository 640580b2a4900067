// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// A dotted path of the project file, in its keys: elements."front left".at.y → elements, front left, at, y. Empty if
/// it is none. Numbers of an array of three are its components x, y and z.
[[nodiscard]] std::vector<std::string> path_keys(const std::string& path);

/// The item of an array of three numbers that a component names: 0 for "x". None of other arrays and words.
[[nodiscard]] std::optional<std::size_t> component_of(const Node& array, const std::string& word);

/// Arrays of three that are 0 where a file leaves them out: their components need no array to be changed.
[[nodiscard]] bool is_zero_by_default(const std::string& key);

/// The value that a path leads to, if there is one.
[[nodiscard]] const Node* node_at(const Node& document, const std::vector<std::string>& keys);

/// The change "path = value", the value a number in `unit` as the file would have it.
[[nodiscard]] Node change_of(const std::vector<std::string>& keys, double value, const std::string& unit);

/// A value and its unit as written: "12 mm" → 12, "mm"; a bare number has the unit "". None if it is no number.
struct WrittenNumber {
  double value = 0;
  std::string unit;
};
[[nodiscard]] std::optional<WrittenNumber> written_number(const Node& node);

/// The number in another unit, both as written; an empty unit is SI. None if they do not measure the same.
[[nodiscard]] std::optional<double> in_unit(const WrittenNumber& number, const std::string& unit);

}  // namespace trivet::project
