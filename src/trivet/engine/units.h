// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/text/display_units.h"

/// Units of numbers that are given to, or shown by, a program around the engine.
namespace trivet::engine {

using DisplayUnits = project::DisplayUnits;

/// Other units of tables and pictures: {"length", "in"}, {"level", "rms"} …; all wrong ones at once.
[[nodiscard]] foundation::Expected<DisplayUnits> changed_units(
    const DisplayUnits& units, const std::vector<std::pair<std::string, std::string>>& changes);

/// A number in another unit of the same quantity. @throws foundation::InvalidInput
[[nodiscard]] double in_unit(double value, const std::string& from, const std::string& to);

/// [rad/s] from a text with a unit. @throws foundation::InvalidInput
[[nodiscard]] double angular_frequency(const std::string& text);

/// Keys of a path such as elements."front left".scale; empty if it is not one.
[[nodiscard]] std::vector<std::string> path_keys(const std::string& path);

}  // namespace trivet::engine
