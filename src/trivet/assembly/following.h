// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/assembly/assembled.h"

namespace trivet::assembly {

/// Forces of an element when everything moves with the ground: matrices × `followed_ends`. Stiffness and damping forces
/// of a rigid motion are zero: an element that meets the rigid-motion rule without a warning is stress-free, and the
/// remainder of its rows is rounding of its data.
struct FollowedForces {
  Eigen::MatrixXd stiffness, damping, mass, loss;
};
[[nodiscard]] FollowedForces followed_forces(const ElementMap& map, const Ground& ground);

/// a q + b g with q = R g, b on all ground coordinates: one number per followed coordinate, zero if it is only
/// round-off of R.
[[nodiscard]] Eigen::RowVectorXd followed_row(const Ground& ground, const Eigen::RowVectorXd& on_coordinates,
                                              const Eigen::RowVectorXd& on_ground);

/// Adds to Ground::together the ground ends that excitations given by velocity or acceleration move together.
void move_together(const model::System& system, Ground& ground);

/// Damping of the whole system (Rayleigh, modal ratios); no rows if there is none.
struct SystemDampingMatrices {
  Eigen::MatrixXd on_coordinates, on_ground;
  bool regular = false;  ///< K is regular: the static motion with the ground is unique
};

/// Fills R, `followed_ends` and the last columns of the ground's matrices, after all else is assembled. Bodies and
/// foundations move rigidly with the ground, internal coordinates as in statics. If something resists (constrained
/// bodies, weights that do not turn with the ground, supports that do not move) and an excitation is given by velocity
/// or acceleration, R is −K⁻¹K_g instead, provided that K is regular.
void follow_ground(const model::System& system, const SystemDampingMatrices& damping, Assembled& assembled);

}  // namespace trivet::assembly
