// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/model/system.h"

namespace trivet::model {

/// Deformation of an element in six directions: motion of end K relative to end N at the elastic centre, in the local
/// axes of K. There the directions are coupled least, so a share of the energy can be called "lateral" or "torsional".
struct ElementDirections {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< from K, local axes of K [m]
  Eigen::Matrix<double, 6, 12> deformation;          ///< from the displacements of the ends
  spatial::Matrix6 stiffness;                        ///< static, with N fixed
};
[[nodiscard]] ElementDirections element_directions(const std::vector<Body>& bodies, const Element& element);

/// The 12×12 stiffness of the ends for a 6×6 in these directions.
[[nodiscard]] elements::Matrix12 between_ends(const ElementDirections& directions, const spatial::Matrix6& stiffness);

/// Name of a stiffness: "lateral stiffness along x", "axial stiffness", "torsional stiffness", or "stiffness along y",
/// "stiffness about z" for an element without an axis along z. @param direction 0 … 5
[[nodiscard]] std::string direction_words(const Element& element, int direction);

}  // namespace trivet::model
