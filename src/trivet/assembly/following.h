// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/assembly/assembled.h"

namespace trivet::assembly {

/// What an element asks for when everything follows the ground: matrices × `followed_ends`. Stiffness and damping of
/// what moves rigidly are zero: an element that passes the rigid-motion rule in silence is stress-free, and what is
/// left of its rows is rounding of its data.
struct FollowedForces {
  Eigen::MatrixXd stiffness, damping, mass;
};
[[nodiscard]] FollowedForces followed_forces(const ElementMap& map, const Ground& ground);

/// a q + b g with q = R g, b by all ground coordinates: one number for each followed one, zero where it is nothing but
/// round-off of R.
[[nodiscard]] Eigen::RowVectorXd followed_row(const Ground& ground, const Eigen::RowVectorXd& on_coordinates,
                                              const Eigen::RowVectorXd& on_ground);

/// Which ground ends the excitations of velocities and accelerations move together.
void move_together(const model::System& system, Ground& ground);

/// Damping of the system as a whole (Rayleigh, modal ratios); no rows if there is none.
struct SystemDampingMatrices {
  Eigen::MatrixXd on_coordinates, on_ground;
  bool regular = false;  ///< of K: the coordinates follow the ground in one way only
};

/// Fills R, `followed_ends` and the last columns of the ground's matrices, when all else is assembled. Bodies and
/// foundations move rigidly with the ground, internal coordinates as they do at rest. Where something resists (guided
/// bodies, weights that do not turn with the ground, supports that stay) and an excitation is given by velocity or
/// acceleration, R is −K⁻¹K_g instead, if K is regular.
void follow_ground(const model::System& system, const SystemDampingMatrices& damping, Assembled& assembled);

}  // namespace trivet::assembly
