// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/unit_prefix.h"

#include <algorithm>
#include <cmath>

namespace trivet::project {

UnitPrefix unit_prefix(double largest, const std::string& unit) {
  static const char* const names[] = {"n", "µ", "m", "", "k", "M"};
  if (!(largest > 0) || !std::isfinite(largest)) return {1, unit};
  int n = static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  n = std::max(-3,
               std::min(unit.starts_with("N") || unit.starts_with("W") ? 2 : 0, n));  // "km/s²" and "krad" are unusual
  return {std::pow(10.0, -3 * n), names[n + 3] + unit};
}

}  // namespace trivet::project
