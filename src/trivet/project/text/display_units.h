// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/foundation/problems.h"
#include "trivet/project/text/level.h"

namespace trivet::project {

/// Units in which tables and pictures show numbers. Files for other programs stay SI.
struct DisplayUnits {
  std::string length = "m";
  std::string force = "N";
  std::string angle = "rad";
  std::string mass = "kg";
  std::string frequency;       ///< of tables and axes; empty: Hz, but rad/s in typed columns and Excel
  std::optional<Level> level;  ///< of all amplitudes; none: the usual one of each, see `shown_level`
  bool operator==(const DisplayUnits&) const = default;
};

/// A unit in place of an SI unit: value × factor.
struct ShownUnit {
  std::string unit;
  double factor = 1;
};

/// Replaces metres, newtons, radians and kilograms in a unit such as "N m" or "m/s²". A unit without them stays.
[[nodiscard]] ShownUnit shown_unit(const DisplayUnits& units, const std::string& si_unit);

/// Replaces rad/s of a frequency axis.
[[nodiscard]] ShownUnit shown_frequency(const DisplayUnits& units);

/// Level at which amplitudes of this SI unit are shown: that of [display], else rms for velocities and zero-to-peak for
/// all others, as standards of machines have them.
[[nodiscard]] Level shown_level(const DisplayUnits& units, const std::string& si_unit);

/// Sets one of length, force, angle, mass, frequency and level, or returns what is wrong with it.
[[nodiscard]] foundation::Problems set_shown_unit(DisplayUnits& units, const std::string& key,
                                                  const std::string& value);

}  // namespace trivet::project
