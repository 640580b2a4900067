// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "trivet/model/system.h"

/// Changes of a described model with all else kept. `explain` tries them; a project file, its cases and --set make them
/// under the same names (docs/project-file.md, "Adjustments").
namespace trivet::response {

/// Adds `gain` times the stiffness of the deformation, a preload kept: `stiffness_factor.all`, which is 1 + gain.
void add_deformation_stiffness(model::Description& description, std::size_t element, double gain);

/// S K S at the elastic centre, in the local axes of K, with S_jj = √factor_j: diagonal entries grow by their factors,
/// couplings follow, and no energy turns negative. `stiffness_factor.x … rz`. @param factors  each > 0
void scale_stiffness_by_direction(model::Description& description, std::size_t element,
                                  const spatial::Vector6& factors);

/// Can its stiffness be scaled by direction? Not where mass or a frequency dependence of its own goes with the
/// stiffness.
[[nodiscard]] bool has_plain_stiffness(const model::Element& element);

/// Does it dissipate by a law that a factor can scale?
[[nodiscard]] bool has_damping(const model::Element& element);

/// Loss factor, matrix or proportional factor times `factor`; of viscoelastic laws all branch ratios: `damping_factor`.
void scale_damping(model::Description& description, std::size_t element, double factor);

/// Both ends by the same vector [m], given in the frame of the body at K, in each end's own frame; the place of a
/// foundation moves with its end, the law stays as it is: `moved.x …`.
void move_element(model::Description& description, std::size_t element, const Eigen::Vector3d& by);

/// Mass times `factor`, centre of mass and inertia about it kept: `mass_about_center`.
void scale_mass(model::Description& description, std::size_t body, double factor);

/// The centre of mass by a vector [m] in the body frame, mass and inertia about the centre kept: `center_moved.x …`.
void move_center_of_mass(model::Description& description, std::size_t body, const Eigen::Vector3d& by);

/// Adds to an entry of the inertia about the centre of mass `share` of J_ii, or of √(J_ii J_jj) to a product of inertia
/// J_ij, in the sign of the project file (Jxy = ∫xy dm): `inertia_about_center.xx …`.
void change_inertia(model::Description& description, std::size_t body, int i, int j, double share);

/// All modal damping ratios times `factor`: `damping.modal_factor`.
void scale_modal_damping(model::Description& description, double factor);

}  // namespace trivet::response
