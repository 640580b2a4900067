// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/coil_spring.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/part_size.h"

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

namespace {

using foundation::Problems;

std::string amount(double value, const char* unit = "") {
  std::ostringstream text;
  text << value << (*unit ? " " : "") << unit;
  return text.str();
}

/// Error unless finite and > 0; NaN is a value not given.
bool positive(Problems& problems, const char* subject, double value, const char* unit) {
  if (std::isfinite(value) && value > 0) return true;
  if (std::isnan(value))
    problems.error(subject, "is missing", "a coil spring needs it",
                   std::string("give it in ") + (*unit ? unit : "numbers"));
  else problems.error(subject, amount(value, unit), "must be finite and > 0", "correct the value");
  return false;
}

/// Error unless the length [m] is one of a part.
bool size(Problems& problems, const char* subject, double value) {
  if (!positive(problems, subject, value, "m")) return false;
  if (foundation::is_part_size(value)) return true;
  problems.error(subject, amount(value, "m"), foundation::part_size_rule, "check the unit and the power of ten");
  return false;
}

void not_negative(Problems& problems, const char* subject, double value, const char* unit) {
  if (!(std::isfinite(value) && value >= 0))
    problems.error(subject, amount(value, unit), "must be finite and ≥ 0", "correct the value");
}

bool check_sizes(Problems& problems, const CoilSpring& spring) {
  bool sound = true;
  if (const auto* round = std::get_if<RoundWire>(&spring.wire)) {
    sound = size(problems, "wire_diameter", round->diameter);
  } else {
    const auto& wire = std::get<RectangularWire>(spring.wire);
    sound = size(problems, "wire_width", wire.radial_width);
    sound = size(problems, "wire_height", wire.axial_height) && sound;
  }
  sound = size(problems, "mean_diameter", spring.mean_diameter) && sound;
  sound = positive(problems, "active_coils", spring.active_coils, "") && sound;
  sound = size(problems, "active_length", spring.active_length) && sound;
  constexpr double most_dead_coils = 1000;
  for (const auto& [subject, coils] :
       {std::pair{"dead_coils_n", spring.dead_coils_n}, {"dead_coils_k", spring.dead_coils_k}})
    if (coils > most_dead_coils)
      problems.error(subject, amount(coils), "at most 1000, as for active coils", "check the number");
  not_negative(problems, "dead_coils_n", spring.dead_coils_n, "");
  not_negative(problems, "dead_coils_k", spring.dead_coils_k, "");
  if (!std::isfinite(spring.start_angle))
    problems.error("start_angle", amount(spring.start_angle, "rad"), "must be finite", "correct the value");
  return sound;
}

void check_proportions(Problems& problems, const CoilSpring& spring) {
  constexpr double fewest_coils = 0.25, usual_coils = 2, lowest_index = 3, usual_index = 4, highest_index = 20,
                   most_coils = 1000;
  const double index = spring_index(spring), pitch = spring.active_length / spring.active_coils,
               height = wire_height(spring);
  const std::string as_index = amount(spring.mean_diameter, "m") + ", " + amount(index) + " times the wire";
  if (index < lowest_index)
    problems.error("mean_diameter", as_index, "the index D/d must be ≥ 3, below it the wire is not a slender rod",
                   "check whether D or d is in the wrong unit");
  else if (index < usual_index || index > highest_index)
    problems.warning("mean_diameter", as_index, "EN 13906-1 holds for an index of 4 to 20",
                     "check the values; the result is that of a slender curved rod");
  if (pitch < height)
    problems.error("active_length", amount(spring.active_length, "m") + ", pitch " + amount(pitch, "m"),
                   "coils overlap: the pitch must be ≥ the height of the wire, " + amount(height, "m"),
                   "lengthen the spring or reduce its coils");
  if (spring.active_coils < fewest_coils)
    problems.error("active_coils", amount(spring.active_coils), "must be ≥ 0.25", "model such a short arc as a beam");
  else if (spring.active_coils > most_coils)
    problems.error("active_coils", amount(spring.active_coils), "at most 1000 are computed",
                   "split such a long spring, or check the number");
  else if (spring.active_coils < usual_coils)
    problems.warning("active_coils", amount(spring.active_coils), "EN 13906-1 holds from 2 active coils",
                     "the ends of a real spring will differ");
}

void check_material(Problems& problems, const CoilSpring& spring, bool massive) {
  const bool young = positive(problems, "youngs_modulus", spring.youngs_modulus, "Pa");
  const bool shear = positive(problems, "shear_modulus", spring.shear_modulus, "Pa");
  const double poisson = spring.youngs_modulus / (2 * spring.shear_modulus) - 1;
  if (young && shear && !(poisson <= 0.5))
    problems.error("shear_modulus", amount(spring.shear_modulus, "Pa"),
                   "E/(2G) − 1, Poisson's ratio, is " + amount(poisson) + ", must be ≤ 0.5", "check E and G");
  if (massive || !std::isnan(spring.density)) positive(problems, "density", spring.density, "kg/m³");
  not_negative(problems, "loss_factor", spring.loss_factor, "");
  if (!std::isnan(spring.shear_factor)) positive(problems, "shear_factor", spring.shear_factor, "");
}

}  // namespace

Problems check(const CoilSpring& spring, bool massive) {
  Problems problems;
  if (check_sizes(problems, spring)) check_proportions(problems, spring);
  check_material(problems, spring, massive);
  return problems;
}

void require_sound(const CoilSpring& spring, bool massive) {
  const Problems problems = check(spring, massive);
  if (const foundation::Problem* first = foundation::first_error(problems))
    throw foundation::InvalidInput("coil spring: " + first->subject + " " + first->finding + ", " + first->rule);
}

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
