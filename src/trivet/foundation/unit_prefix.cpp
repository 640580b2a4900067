// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/unit_prefix.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/significant_digits.h"

namespace trivet::foundation {

namespace {

/// Standards of machines state velocities in mm/s: 0.4 mm/s is not 400 µm/s beside a limit of 4.5 mm/s.
/// The levels of laboratories, VC-A and below, are published in µm/s.
constexpr double least_in_millimetres_per_second = 1e-4;  // [m/s]

/// Power of a thousand that brings a number near 1 … 1000.
int thousands(double largest, const std::string& unit) {
  const int power = static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  constexpr double round_off = 1e-9;
  if (unit == "m/s" && power == -2 && largest >= least_in_millimetres_per_second * (1 - round_off)) return -1;
  return power;
}

}  // namespace

UnitPrefix unit_prefix(double largest, const std::string& unit) {
  static const char* const names[] = {"n", "µ", "m", "", "k", "M"};
  const bool has_prefix = unit.starts_with("kg");
  if (!(largest > 0) || !std::isfinite(largest) || has_prefix) return {1, unit};
  const bool has_large = unit.starts_with("N") || unit.starts_with("W") || unit.starts_with("Pa");
  const int n = std::clamp(thousands(largest, unit), -3, has_large ? 2 : 0);  // "km/s²" and "krad" are unusual
  return {std::pow(10.0, -3 * n), names[n + 3] + unit};
}

std::string prefixed(double value, const std::string& unit) { return prefixed_exactly(value, unit, 4); }

}  // namespace trivet::foundation
