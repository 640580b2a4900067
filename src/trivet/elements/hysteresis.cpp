// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/hysteresis.h"

#include <algorithm>

#include "trivet/elements/hysteretic_branch.h"

namespace trivet::elements {
ForceOnTravel force_on_travel(const HystereticForce& law, double start, double travel) {
  return HystereticBranch(law, start, travel).at(travel);
}

ForceOnTravel virgin_force(const HystereticForce& law, double deflection) {
  if (jumps_at_turns(law)) return {};
  if (const auto* slider = std::get_if<Slider>(&law))
    return force_on_travel(Slider{slider->stiffness, slider->slip}, 0, deflection);
  return force_on_travel(law, 0, deflection);
}

std::vector<double> virgin_kinks(const HystereticForce& law) {
  const auto* slider = std::get_if<Slider>(&law);
  if (!slider) return {};
  const double slips_at = slider->slip / slider->stiffness;
  return {-slips_at, slips_at};
}

double jump_at_kink(const HystereticForce& law, double direction) {
  const auto* slider = std::get_if<Slider>(&law);
  return slider ? direction * (slider->slip - slider->limit()) : 0;
}

double jump_at_turn(const HystereticForce& law, double start, double direction) {
  const auto* friction = std::get_if<CoulombFriction>(&law);
  return friction ? direction * friction->slip - start : 0;
}

bool jumps_at_turns(const HystereticForce& law) { return std::holds_alternative<CoulombFriction>(law); }

bool is_piecewise_linear(const HystereticForce& law) {
  return std::holds_alternative<Slider>(law) || jumps_at_turns(law);
}

double initial_stiffness(const HystereticForce& law) {
  if (jumps_at_turns(law)) return 0;
  if (const auto* berg = std::get_if<BergFriction>(&law)) return berg->force / berg->deflection;
  if (const auto* slider = std::get_if<Slider>(&law)) return slider->stiffness;
  return std::get<BoucWen>(law).stiffness;
}

double force_limit(const HystereticForce& law) {
  if (const auto* berg = std::get_if<BergFriction>(&law)) return berg->force;
  if (const auto* slider = std::get_if<Slider>(&law)) return slider->limit();
  if (const auto* friction = std::get_if<CoulombFriction>(&law)) return friction->slip;
  const auto& smooth = std::get<BoucWen>(law);
  return smooth.force * std::max(z_limit(smooth), z_limit(mirrored(smooth)));
}

}  // namespace trivet::elements
