// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/coil_stress.h"

#include <cmath>
#include <numbers>

#include "trivet/foundation/invalid_input.h"

namespace trivet::elements {
namespace {

/// Largest stress over (torsion moment × short side/J) of a rectangle in St Venant torsion.
double rectangle_peak(double long_side, double short_side) {
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  for (int k = 1; k < 40; k += 2) sum += 1 / (k * k * std::cosh(k * pi * long_side / (2 * short_side)));
  return 1 - 8 / (pi * pi) * sum;
}

}  // namespace

double wahl_factor(double index) { return (4 * index - 1) / (4 * index - 4) + 0.615 / index; }

double bergstraesser_factor(double index) { return (index + 0.5) / (index - 0.75); }

double nominal_shear_stress(const CoilSpring& spring, double axial_force) {
  require_sound(spring, false);
  const double moment = std::abs(axial_force) * spring.mean_diameter / 2;
  if (const auto* round = std::get_if<RoundWire>(&spring.wire))
    return 16 * moment / (std::numbers::pi * std::pow(round->diameter, 3));
  const auto [width, height] = std::get<RectangularWire>(spring.wire);
  const double longer = std::max(width, height), shorter = std::min(width, height);
  return moment * shorter / wire_section(spring).torsion_constant * rectangle_peak(longer, shorter);
}

double wahl_shear_stress(const CoilSpring& spring, double axial_force) {
  if (!std::holds_alternative<RoundWire>(spring.wire))
    throw foundation::InvalidInput(
        "coil spring: Wahl's factor is for round wire; use nominal_shear_stress for a rectangular one");
  return wahl_factor(spring_index(spring)) * nominal_shear_stress(spring, axial_force);
}

}  // namespace trivet::elements
