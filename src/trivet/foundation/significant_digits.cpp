// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/significant_digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/unit_prefix.h"

namespace trivet::foundation {

std::string significant(double value, int digits) {
  constexpr double in_full = 1e7;  // four digits would make 12000 kg 1.2e+04 kg
  const bool is_long = std::abs(value) >= std::pow(10.0, digits) - 0.5 && std::abs(value) < in_full;
  return is_long ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

std::string prefixed_exactly(double value, const std::string& unit, int digits) {
  const UnitPrefix prefix = unit_prefix(std::abs(value), unit);
  return significant(value * prefix.factor, digits) + " " + prefix.unit;
}

std::string prefixed_range(double from, double to, const std::string& unit) {
  const UnitPrefix prefix = unit_prefix(std::max(std::abs(from), std::abs(to)), unit);
  return significant(from * prefix.factor) + " … " + significant(to * prefix.factor) + " " + prefix.unit;
}

}  // namespace trivet::foundation
