// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "trivet/model/system.h"

/// Changes of a model description, each with all else kept. `explain` tries them; a project file, its cases and --set
/// apply them under the same names (docs/project-file.md, "Adjustments").
namespace trivet::model {

/// Key of the number that scales the whole stiffness of an element: `scale`, or `stiffness_factor.all` of a preloaded
/// one, which keeps its preload. Empty: the element has no stiffness, or that of its deflection.
[[nodiscard]] std::string_view stiffness_key(const Element& element);

/// Adds `gain` times the stiffness of the deformation and keeps a preload: `stiffness_factor.all` = 1 + gain.
void add_deformation_stiffness(Description& description, std::size_t element, double gain);

/// Replaces K by S K S at the elastic centre, in the local axes of end K, with S_jj = √factor_j: diagonal entries grow
/// by their factors, couplings accordingly, and no energy becomes negative. `stiffness_factor.x … rz`.
/// @param factors  each > 0
void scale_stiffness_by_direction(Description& description, std::size_t element, const spatial::Vector6& factors);

/// True if the stiffness can be scaled by direction: the element has no mass and no frequency dependence.
[[nodiscard]] bool has_plain_stiffness(const Element& element);

/// True if the element has damping that a factor can scale.
[[nodiscard]] bool has_damping(const Element& element);

/// Multiplies loss factor, matrix or proportional factor by `factor`; for viscoelastic laws all branch ratios:
/// `damping_factor`.
void scale_damping(Description& description, std::size_t element, double factor);

/// Moves both ends by the same vector [m], given in the frame of the body at K. A foundation moves with its end; the
/// law does not change: `moved.x …`.
void move_element(Description& description, std::size_t element, const Eigen::Vector3d& by);

/// Multiplies the mass by `factor`; centre of mass and inertia about it are kept: `mass_about_center`.
void scale_mass(Description& description, std::size_t body, double factor);

/// Moves the centre of mass by a vector [m] in the body frame; mass and inertia about the centre are kept:
/// `center_moved.x …`.
void move_center_of_mass(Description& description, std::size_t body, const Eigen::Vector3d& by);

/// Adds `share` of J_ii to an entry of the inertia about the centre of mass, or of √(J_ii J_jj) to a product of inertia
/// J_ij, with the sign of the project file (Jxy = ∫xy dm): `inertia_about_center.xx …`.
void change_inertia(Description& description, std::size_t body, int i, int j, double share);

/// Multiplies all modal damping ratios by `factor`: `damping.modal_factor`.
void scale_modal_damping(Description& description, double factor);

}  // namespace trivet::model
