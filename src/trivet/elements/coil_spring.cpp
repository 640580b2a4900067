// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/coil_spring.h"

#include <cmath>
#include <numbers>

namespace trivet::elements {
namespace {

/// St Venant's torsion constant of a rectangle; five terms of the series reach 1e-16.
double wire_torsion_constant(double long_side, double short_side) {
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  for (int k = 1; k < 40; k += 2) sum += std::tanh(k * pi * long_side / (2 * short_side)) / std::pow(k, 5);
  return long_side * std::pow(short_side, 3) * (1.0 / 3 - 64 / std::pow(pi, 5) * short_side / long_side * sum);
}

}  // namespace

double wire_height(const CoilSpring& spring) {
  if (const auto* round = std::get_if<RoundWire>(&spring.wire)) return round->diameter;
  return std::get<RectangularWire>(spring.wire).axial_height;
}

double spring_index(const CoilSpring& spring) {
  if (const auto* round = std::get_if<RoundWire>(&spring.wire)) return spring.mean_diameter / round->diameter;
  return spring.mean_diameter / std::get<RectangularWire>(spring.wire).radial_width;
}

double seat_distance(const CoilSpring& spring) {
  return spring.active_length + (spring.dead_coils_n + spring.dead_coils_k) * wire_height(spring);
}

WireSection wire_section(const CoilSpring& spring) {
  const double poisson = spring.youngs_modulus / (2 * spring.shear_modulus) - 1;
  WireSection section;
  if (const auto* round = std::get_if<RoundWire>(&spring.wire)) {
    const double d = round->diameter, I = std::numbers::pi * std::pow(d, 4) / 64;
    section = {std::numbers::pi * d * d / 4, 6 * (1 + poisson) / (7 + 6 * poisson), 2 * I, {I, I, 2 * I}};
  } else {
    const auto [b, h] = std::get<RectangularWire>(spring.wire);
    const double I1 = b * h * h * h / 12, I2 = h * b * b * b / 12;
    section = {b * h,
               10 * (1 + poisson) / (12 + 11 * poisson),
               wire_torsion_constant(std::max(b, h), std::min(b, h)),
               {I1, I2, I1 + I2}};
  }
  if (!std::isnan(spring.shear_factor)) section.shear_factor = spring.shear_factor;
  return section;
}

}  // namespace trivet::elements
