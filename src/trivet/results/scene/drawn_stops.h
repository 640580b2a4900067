// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"

namespace trivet::results {

/// One side of a gap of an element, at rest, ground frame.
struct DrawnStop {
  /// Of a travel along `direction`, of a turn about it, of a pin across the axis `direction` of its ring, or of the
  /// distance of the ends, along `direction` from N to K.
  enum class Kind { travel, turn, ring, distance };
  std::size_t element = 0;
  Kind kind = Kind::travel;
  Eigen::Vector3d at;         ///< [m]
  Eigen::Vector3d direction;  ///< unit vector: in which end K moves, seen from end N, until the gap closes
  double gap = 0;             ///< that is left at rest [m, rad]; negative: it is closed
};

/// Of all elements in their order; not the gaps within an element, such as that of a decoupler.
[[nodiscard]] std::vector<DrawnStop> drawn_stops(const model::System& system);
[[nodiscard]] const char* word_of(DrawnStop::Kind kind);

}  // namespace trivet::results
