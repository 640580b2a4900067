// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/lugre_friction.h"

#include <cmath>

namespace trivet::elements {

BristleDecay bristle_decay(const LuGreFriction& law, double rate, double sense) {
  const double towards = sense < 0 ? -1 : 1;
  if (!law.has_stribeck_effect()) return {towards * law.stiffness / law.slip, 0};
  const double ratio = rate / law.stribeck_velocity, above = (law.breakaway - law.slip) * std::exp(-ratio * ratio),
               steady = law.slip + above, per_travel = towards * law.stiffness / steady;
  return {per_travel, per_travel * 2 * ratio / law.stribeck_velocity * above / steady};
}

VirginBristles virgin_force(const LuGreFriction& law, double deflection) {
  const double reached = -std::expm1(-law.stiffness * std::abs(deflection) / law.limit());
  return {std::copysign(law.limit() * reached, deflection), law.stiffness * (1 - reached)};
}

double least_passive_viscous(const LuGreFriction& law) { return law.damping * (law.limit() / law.slip - 1); }

}  // namespace trivet::elements
