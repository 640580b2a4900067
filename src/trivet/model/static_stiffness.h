// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::model {

// Rubber is softer under a static load than in vibration: `Element::stiffening`. The laws of a system are those of
// vibration.

/// Has an element a static stiffness of its own? Never in a machine with nonlinear parts, where one force is that of
/// rest and of vibration.
[[nodiscard]] bool has_static_stiffness(const System& system);

/// The same machine with the static stiffnesses of its elements.
[[nodiscard]] System with_static_stiffness(const System& system);

/// Directions in which a unit motion of the node causes a force in an element, or an element exerts one on it: by
/// stiffness, damping or mass, beyond round-off.
[[nodiscard]] std::array<bool, 6> held_directions(const Description& description, std::size_t node);

/// Number of free coordinates of a node or a point mass that have mass, or get it from an element.
[[nodiscard]] std::size_t coordinates_with_mass(const Description& description, std::size_t node);

/// A motion of nodes that no stiffness resists.
struct UnheldMotion {
  std::size_t node = 0;                                    ///< the node that moves most
  spatial::Vector6 directions = spatial::Vector6::Zero();  ///< its motion; parts that are round-off are zero
  bool only_dampers = false;
  std::string with;         ///< names of the other nodes that move
  std::size_t further = 0;  ///< number of further motions of several nodes
};

/// All motions of single nodes, or, if there is none, one of several nodes together. Bodies and foundations are held.
[[nodiscard]] std::vector<UnheldMotion> unheld_motions(const Description& description);

}  // namespace trivet::model
