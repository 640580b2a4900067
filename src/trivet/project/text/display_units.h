// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::project {

/// Level of a harmonic quantity.
enum class Level { amplitude, peak_to_peak, rms };

/// Units in which tables and pictures show numbers. Files for other programs stay SI.
struct DisplayUnits {
  std::string length = "m";
  std::string force = "N";
  std::string angle = "rad";
  std::string mass = "kg";
  std::string frequency;  ///< of tables and axes; empty: Hz, but rad/s in typed columns and Excel
  Level level = Level::amplitude;
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

/// Share of an amplitude: 2 for peak-to-peak, 1/√2 for an effective value.
[[nodiscard]] double level_factor(Level level);
[[nodiscard]] const char* level_name(Level level);

/// Sets one of length, force, angle, mass, frequency and level, or returns what is wrong with it.
[[nodiscard]] foundation::Problems set_shown_unit(DisplayUnits& units, const std::string& key,
                                                  const std::string& value);

}  // namespace trivet::project
