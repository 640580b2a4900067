// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/table_reader.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

/// Unit of measured values: a motion, force or moment, perhaps divided by a force or moment.
struct MeasuredUnit {
  Quantity quantity = Quantity::length;  ///< length … acceleration, angle … angular_acceleration, force, moment
  double factor = 1;                     ///< to SI, with the load
  bool per_load = false;
  std::string text = {};    ///< as it was written
  double load = 1;          ///< the load to SI
  bool load_turns = false;  ///< the load is a moment
  bool assumed = false;     ///< SI, because neither the file nor the project states it, which states that of others
};

/// Units of the key `unit`. Each is for the functions of its quantity and of its load; one without a load for any load.
using GivenUnits = std::vector<MeasuredUnit>;

/// Unit of a text such as "m/s2" or "(mm/s)/N"; none if it is not one of a motion, force or moment.
[[nodiscard]] std::optional<MeasuredUnit> measured_unit(const std::string& text);

/// The key `unit` of a measurement: one unit or several, of different quantities or loads. Empty without it; none after
/// an error.
[[nodiscard]] std::optional<GivenUnits> read_given_units(TableReader& reader);

/// "unit = "g/N" of the project", for messages.
[[nodiscard]] std::string unit_words(const GivenUnits& units);

/// False for forces and moments.
[[nodiscard]] bool is_motion(Quantity quantity);
/// True for angles, their derivatives and moments.
[[nodiscard]] bool is_rotation(Quantity quantity);

/// Number of derivatives in time of a motion: 0 for a length or an angle, 2 for an acceleration; 0 for forces.
[[nodiscard]] int derivatives_of(Quantity quantity);
/// The quantity without its derivatives: length, angle, force or moment.
[[nodiscard]] Quantity underived(Quantity quantity);

}  // namespace trivet::project
