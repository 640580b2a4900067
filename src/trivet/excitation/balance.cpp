// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/balance.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {

double permissible_unbalance(double grade_mm_per_s, double mass, double angular_speed) {
  const auto require_positive = [](double value, const char* name, const char* unit) {
    if (!(value > 0) || !std::isfinite(value)) throw foundation::InvalidInput(fmt::format("{} = {:.6g} {}: it must be > 0", name, value, unit));
  };
  require_positive(grade_mm_per_s, "balance grade", "mm/s");
  require_positive(mass, "rotor mass", "kg");
  require_positive(angular_speed, "speed", "rad/s");
  return 1e-3 * grade_mm_per_s * mass / angular_speed;
}

}  // namespace trivet::excitation
