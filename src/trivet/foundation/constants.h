// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <numbers>

/// Constants used in several modules.
namespace trivet::foundation {

inline constexpr double two_pi = 2 * std::numbers::pi;  ///< one turn [rad]
inline constexpr double rpm_per_rad_s = 60 / two_pi;    ///< revolutions per minute of 1 rad/s
inline constexpr double standard_gravity = 9.80665;     ///< [m/s²], ISO 80000-3
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();  ///< twice the unit round-off

}  // namespace trivet::foundation
