// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/balance.h"

#include "trivet/excitation/refusal.h"

namespace trivet::excitation {

double permissible_unbalance(double grade_mm_per_s, double mass, double angular_speed) {
  require_positive(grade_mm_per_s, "balance grade", "mm/s");
  require_positive(mass, "rotor mass", "kg");
  require_positive(angular_speed, "speed", "rad/s");
  return 1e-3 * grade_mm_per_s * mass / angular_speed;
}

}  // namespace trivet::excitation
