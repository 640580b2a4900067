// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/project/text/table_reader.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

/// Unit of measured values: a motion, force or moment, perhaps divided by a force or moment.
struct MeasuredUnit {
  Quantity quantity = Quantity::length;  ///< length … acceleration, angle … angular_acceleration, force, moment
  double factor = 1;                     ///< to SI, with the load
  bool per_load = false;
  std::string text = {};  ///< as it was written
  double load = 1;        ///< the load to SI
};

/// Unit of a text such as "m/s2" or "(mm/s)/N"; none if it is not one of a motion, force or moment.
[[nodiscard]] std::optional<MeasuredUnit> measured_unit(const std::string& text);

/// The key `unit` of a measurement; none without it, or after an error.
[[nodiscard]] std::optional<MeasuredUnit> read_measured_unit(TableReader& reader);

/// Number of derivatives in time of a motion: 0 for a length or an angle, 2 for an acceleration; 0 for forces.
[[nodiscard]] int derivatives_of(Quantity quantity);
/// The quantity without its derivatives: length, angle, force or moment.
[[nodiscard]] Quantity underived(Quantity quantity);

}  // namespace trivet::project
