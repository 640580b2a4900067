// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/unit_prefix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trivet::foundation {

UnitPrefix unit_prefix(double largest, const std::string& unit) {
  static const char* const names[] = {"n", "µ", "m", "", "k", "M"};
  if (!(largest > 0) || !std::isfinite(largest)) return {1, unit};
  int n = static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  n = std::max(-3,
               std::min(unit.starts_with("N") || unit.starts_with("W") ? 2 : 0, n));  // "km/s²" and "krad" are unusual
  return {std::pow(10.0, -3 * n), names[n + 3] + unit};
}

std::string prefixed(double value, const std::string& unit) {
  const UnitPrefix prefix = unit_prefix(std::abs(value), unit);
  return fmt::format("{:.4g} {}", value * prefix.factor, prefix.unit);
}

}  // namespace trivet::foundation
