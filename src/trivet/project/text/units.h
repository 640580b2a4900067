// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/foundation/problems.h"

namespace trivet::project {

/// What a number of the project file measures; its SI unit stands in `si_unit`.
enum class Quantity {
  pure,
  length,
  mass,
  inertia,
  angle,
  angular_frequency,
  time,
  per_time,
  force,
  moment,
  acceleration,
  velocity,
  angular_velocity,
  angular_acceleration,
  force_per_length,
  force_per_angle,
  moment_per_length,
  moment_per_angle,
  damping_force_per_length,
  damping_force_per_angle,
  damping_moment_per_length,
  damping_moment_per_angle,
  pressure,
  density,
  mass_length
};

[[nodiscard]] const char* si_unit(Quantity quantity);

/// "452.3 lb" → 205.16 for a mass. Angle is a dimension of its own here and energy another, so that Hz is 2π rad/s, and
/// "5 rad" is no pure number nor "5 J" a moment. The result is the value or what is wrong with the text.
[[nodiscard]] tl::expected<double, std::string> to_si(std::string_view text, Quantity quantity);

}  // namespace trivet::project
