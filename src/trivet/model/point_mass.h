// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "trivet/model/system.h"

namespace trivet::model {

/// A body with a mass, a pole at its centre and an inertia of exactly zero: its rotations are those of a node.
[[nodiscard]] inline bool is_point_mass(const Body& body) {
  return !body.is_node && body.has_inertia && body.mass.mass > 0 && body.mass.centre.isZero(0) &&
      body.mass.inertia_about_centre.isZero(0);
}

/// True if the coordinate gets no mass from the body itself.
[[nodiscard]] inline bool is_massless(const Body& body, std::size_t coordinate) {
  return body.is_node || (coordinate >= 3 && is_point_mass(body));
}

/// True for nodes and point masses, whose rotations have no mass.
[[nodiscard]] inline bool turns_without_mass(const Body& body) { return is_massless(body, 3); }

}  // namespace trivet::model
