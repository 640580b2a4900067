// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

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

/// Reads the units from this copy of the database of UDUNITS-2 instead of that of the system. Call it before the first
/// unit is read, from one thread.
void use_unit_database(const std::string& file);

}  // namespace trivet::project
