// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/admissible_range.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/hertz.h"

namespace trivet::project {

Largest largest(Quantity quantity) {
  constexpr const char* of_force = "the thrust of the largest rocket is 1e8 N";
  constexpr const char* of_stiffness = "a cube of steel of 1 km has 2e14 N/m";
  constexpr const char* of_damping = "it is mω of a mountain of 1e12 kg at 1e6 rad/s";
  switch (quantity) {
    case Quantity::pure:
      return {1e30, "no plain number of a machine is larger"};
    case Quantity::length:
      return {1e9, "the moon is at 4e8 m"};
    case Quantity::area:
      return {1e15, "the earth has 5e14 m²"};
    case Quantity::volume:
      return {1e22, "the earth has 1.1e21 m³"};
    case Quantity::mass:
      return {1e15, "a mountain has less"};
    case Quantity::inertia:
      return {1e24, "a mountain of 1e15 kg has less"};
    case Quantity::mass_length:
      return {1e18, "a mountain has less"};
    case Quantity::density:
      return {1e8, "the core of the sun has 1.5e5 kg/m³"};
    case Quantity::angle:
      return {1e9, "double precision no longer resolves a part of a turn"};
    case Quantity::angular_frequency:
      return {1e12, "atoms of a solid vibrate at 1e13 rad/s"};
    case Quantity::time:
      return {1e15, "30 million years"};
    case Quantity::per_time:
      return {1e15, "atoms of a solid vibrate at 1e13 rad/s"};
    case Quantity::time_per_length:
    case Quantity::time_per_angle:
      return {1e9, "at unit speed the force of a stop would be 1e9 times that at rest"};
    case Quantity::velocity:
      return {3e8, "the speed of light"};
    case Quantity::angular_velocity:
      return {1e12, "atoms of a solid vibrate at 1e13 rad/s"};
    case Quantity::acceleration:
      return {1e15, "a bullet in its barrel has 1e6 m/s²"};
    case Quantity::angular_acceleration:
      return {1e18, "no part of a machine turns so abruptly"};
    case Quantity::force:
      return {1e15, of_force};
    case Quantity::moment:
    case Quantity::energy:
      return {1e18, of_force};
    case Quantity::pressure:
      return {1e15, "diamond has 1.2e12 Pa"};
    case Quantity::force_per_length:
      return {1e18, of_stiffness};
    case Quantity::force_per_angle:
    case Quantity::moment_per_length:
      return {1e21, of_stiffness};
    case Quantity::moment_per_angle:
    case Quantity::force_per_length_squared:
      return {1e24, of_stiffness};
    case Quantity::force_per_length_cubed:
      return {1e30, of_stiffness};
    case Quantity::moment_per_angle_squared:
    case Quantity::moment_per_angle_cubed:
      return {1e27, of_stiffness};
    case Quantity::damping_force_per_length:
    case Quantity::damping_force_per_velocity_squared:
    case Quantity::damping_moment_per_velocity_squared:
      return {1e18, of_damping};
    case Quantity::damping_force_per_angle:
    case Quantity::damping_moment_per_length:
      return {1e21, of_damping};
    case Quantity::damping_moment_per_angle:
      return {1e24, of_damping};
    case Quantity::temperature:
      return {1e5, "the surface of the sun has 5800 K"};
  }
  return {1e30, ""};
}

std::optional<std::string> outside_range(double value, Quantity quantity) {
  const Largest most = largest(quantity);
  const std::string unit = si_unit(quantity);
  if (std::abs(value) > most.magnitude && quantity == Quantity::angular_frequency)
    return fmt::format("at most {:.1e} Hz in magnitude is allowed here, {:.0e} rad/s ({})",
                       foundation::hertz(most.magnitude), most.magnitude, most.reason);
  if (std::abs(value) > most.magnitude)
    return fmt::format("at most {:.0e}{}{} in magnitude is allowed here ({})", most.magnitude, unit.empty() ? "" : " ",
                       unit, most.reason);
  if (quantity == Quantity::temperature && value < 0) return "no temperature is below −273.15 °C, 0 K";
  if (value != 0 && std::abs(value) < smallest_number)
    return fmt::format("a number is 0 or at least {:.0e} in magnitude: products of smaller ones underflow",
                       smallest_number);
  return std::nullopt;
}

std::optional<std::string> wrong_band(double from, double to) {
  constexpr double narrowest = 1e-9;  // of its upper end: below it, results do not differ and grids repeat their points
  constexpr double lowest = 1e-9;     // [rad/s] a turn in 200 years
  if (!(from >= 0 && to > from)) return "[from, to] with 0 ≤ from < to";
  if (to - from < narrowest * to) return fmt::format("its ends differ by {:.0e} of the upper one or more", narrowest);
  if (to < lowest) return fmt::format("its upper end is {:.1e} Hz or more", foundation::hertz(lowest));
  return std::nullopt;
}

}  // namespace trivet::project
