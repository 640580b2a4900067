// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// A dotted path of the project file, in its keys: elements."front left".scale → elements, front left, scale. Empty if it is none.
[[nodiscard]] std::vector<std::string> path_keys(const std::string& path);

/// What stands behind a path, if anything does.
[[nodiscard]] const Node* behind(const Node& document, const std::vector<std::string>& keys);

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
