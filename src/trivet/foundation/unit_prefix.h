// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::foundation {

/// A factor 10^(3n) that brings `largest` near 1 … 1000, and the resulting unit: 0.01 m → 1000, "mm". Only newtons and
/// watts get larger units. A number that is 0 chooses no prefix.
struct UnitPrefix {
  double factor = 1;
  std::string unit;
};
[[nodiscard]] UnitPrefix unit_prefix(double largest, const std::string& unit);

/// An SI number with its prefix, four digits: "243.7 kN/m", "-2.85 mm".
[[nodiscard]] std::string prefixed(double value, const std::string& unit);

}  // namespace trivet::foundation
