// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "trivet/design/design_rules.h"

namespace trivet::study {

/// Least ln(margin) of what counts as met: nine digits.
inline constexpr double least_met = -1e-9;

/// Limit over value, 1 within nine digits of the limit.
[[nodiscard]] inline double margin_of(double allowed, double value) {
  return design::margin({.allowed = allowed}, std::abs(value));
}

/// Value over limit, for what has to be large.
[[nodiscard]] inline double margin_of_least(double least, double value) {
  return value > 0 ? margin_of(value, least) : 0;
}

/// Factor from a natural frequency ω to the nearer end of a window without natural frequencies; below 1 inside it,
/// but 1 within nine digits of its ends.
[[nodiscard]] inline double margin_outside(const assembly::Band& window, double omega) {
  return std::max(margin_of(window.from, omega), margin_of(omega, window.to));
}

}  // namespace trivet::study
