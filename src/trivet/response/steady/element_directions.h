// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/model/system.h"

namespace trivet::response {

/// The deformation of an element in six directions: motion of K relative to N, seen at the element's elastic centre in
/// the local axes of K. There the directions are coupled least, so that a share of the energy can be called "lateral"
/// or "torsional".
struct ElementDirections {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< from K, local axes of K [m]
  Eigen::Matrix<double, 6, 12> deformation;          ///< from the displacements of the ends
  spatial::Matrix6 stiffness;                        ///< at rest, N held
};
[[nodiscard]] ElementDirections element_directions(const std::vector<model::Body>& bodies,
                                                   const model::Element& element);

/// The 12×12 that a 6×6 in these directions adds.
[[nodiscard]] elements::Matrix12 between_ends(const ElementDirections& directions, const spatial::Matrix6& stiffness);

/// "lateral stiffness along x", "axial stiffness", "torsional stiffness", or "stiffness along y", "stiffness about z"
/// where an element's z is no axis of its own. @param direction 0 … 5
[[nodiscard]] std::string direction_words(const model::Element& element, int direction);

}  // namespace trivet::response
