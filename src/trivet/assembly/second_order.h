// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"

namespace trivet::assembly {

/// What the forces at rest add to the stiffness: docs/theory.md, "Forces at rest".
struct SecondOrder {
  /// Per element: its forces turn with it, axes of its ends. 0 for an element whose tangent contains this.
  std::vector<elements::Matrix12> of_elements;
  /// Free coordinates: the points of bodies at which forces act move on circles as bodies rotate.
  Eigen::MatrixXd of_levers;
  std::vector<std::size_t> without_rest;  ///< bodies that their weight moves without end: not included
  bool hangs_aside = false;               ///< some forces are those of a hung body that swings aside
};

/// Of gravity, constant forces and preloads, by the forces of the machine of the first order, with the static stiffness
/// of its rubber. A hung part that K₀ does not hold has the forces of its position of rest, if that is near the
/// drawing. Parts of the machine all of whose elements have a preload keep `geometric_stiffness`.
/// @param first  the machine of the first order
[[nodiscard]] SecondOrder second_order(const model::System& system, const Assembled& first);

/// The same as a function of the coordinates at rest, added to K of the first order: constant + Σ q_k per_coordinate_k.
struct SecondOrderForms {
  Eigen::MatrixXd constant;
  std::vector<Eigen::MatrixXd> per_coordinate;  ///< free coordinates, each n × n [N/m per m …]

  /// @param rest  coordinates under the whole load to first order, with the static stiffness of rubber
  [[nodiscard]] Eigen::MatrixXd at(const Eigen::VectorXd& rest) const;
};
[[nodiscard]] SecondOrderForms second_order_forms(const model::System& system, const Assembled& first);

/// Does the model ask for it: is there a weight?
[[nodiscard]] bool has_second_order(const model::System& system);

}  // namespace trivet::assembly
