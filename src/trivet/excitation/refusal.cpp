// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/refusal.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {
namespace {

void require(bool met, double value, std::string_view quantity, std::string_view unit, std::string_view rule) {
  if (!met || !std::isfinite(value))
    throw foundation::InvalidInput(
        fmt::format("{} = {:.6g}{}{}: it must be {}", quantity, value, unit.empty() ? "" : " ", unit, rule));
}

}  // namespace

void require_finite(double value, std::string_view quantity, std::string_view unit) {
  require(true, value, quantity, unit, "finite");
}

void require_positive(double value, std::string_view quantity, std::string_view unit) {
  require(value > 0, value, quantity, unit, "> 0");
}

void require_not_negative(double value, std::string_view quantity, std::string_view unit) {
  require(value >= 0, value, quantity, unit, "≥ 0");
}

void require_damping_ratio(double zeta) { require(zeta >= 0 && zeta < 1, zeta, "damping ratio", "", "≥ 0 and < 1"); }

}  // namespace trivet::excitation
