// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::project {

/// Physical quantity of a number in the project file; `si_unit` has its SI unit.
enum class Quantity {
  pure,
  length,
  area,
  volume,
  mass,
  inertia,
  angle,
  angular_frequency,
  time,
  per_time,
  time_per_length,
  time_per_angle,
  force,
  moment,
  energy,
  acceleration,
  velocity,
  angular_velocity,
  angular_acceleration,
  force_per_length,
  force_per_angle,
  moment_per_length,
  moment_per_angle,
  force_per_length_squared,
  force_per_length_cubed,
  moment_per_angle_squared,
  moment_per_angle_cubed,
  damping_force_per_length,
  damping_force_per_velocity_squared,
  damping_moment_per_velocity_squared,
  damping_force_per_angle,
  damping_moment_per_length,
  damping_moment_per_angle,
  pressure,
  density,
  mass_length,
  temperature
};

[[nodiscard]] const char* si_unit(Quantity quantity);

/// The same as it is printed: "kg m²"; empty for a pure number.
[[nodiscard]] std::string printed_si_unit(Quantity quantity);

/// SI value of a text, "452.3 lb" → 205.16 for a mass, or the reason why it has none. Angle and energy are separate
/// dimensions here: Hz is 2π rad/s, "5 rad" is not a pure number and "5 J" is not a moment.
[[nodiscard]] tl::expected<double, std::string> to_si(std::string_view text, Quantity quantity);

// Units that belong to no single quantity: those of spectral densities, and the ratio of two units (units.cpp).

/// SI unit of a spectral density of this quantity over hertz, "(m/s2)2/Hz", and the value in it of a text:
/// "0.04 g^2/Hz" → 3.8468 for an acceleration.
[[nodiscard]] std::string density_unit(Quantity quantity);
[[nodiscard]] tl::expected<double, std::string> to_density(std::string_view text, Quantity quantity);

/// How many `other` a `unit` has: 1000 for "kN/mm" and "N/mm"; none if they measure different quantities or one is not
/// a unit.
[[nodiscard]] std::optional<double> unit_ratio(const std::string& unit, const std::string& other);

// Units as people write them, for `units` only.

/// The unit in the spelling of the table of units: superscripts as digits, "short ton" as one word, and 1/min, min⁻¹
/// and U/min as rpm if a rotational speed is expected. @param si  the expected SI unit
[[nodiscard]] std::string one_spelling(std::string_view unit, std::string_view si);

/// Why a unit with a word of several meanings is rejected, with the words to choose from; empty for any other.
[[nodiscard]] std::string reason_against_ambiguous(std::string_view unit, std::string_view si);

/// The unit with each word replaced: "lb/in" with lb → lbf is "lbf/in". Equal to `unit` if the word is not there.
[[nodiscard]] std::string with_word_replaced(std::string_view unit, std::string_view word, std::string_view by);

/// Words of mass that catalogues write for a force, with the unit of force that is meant.
struct MassForForce {
  const char *mass, *force;
};
[[nodiscard]] const std::vector<MassForForce>& masses_for_forces();

}  // namespace trivet::project
