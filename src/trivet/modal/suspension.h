// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/elements/stiffness_properties.h"
#include "trivet/modal/modes.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::modal {

/// Rows of a body's free coordinates, and of the coordinates that follow it: of nodes, and inner ones of the elements
/// that hold it or these nodes.
struct BodyRows {
  std::vector<Eigen::Index> body, inner;
  std::vector<int> coordinates;  ///< of `body`, 0 … 5
  std::vector<bool> moving;      ///< the body, and the nodes that elements join to it
};
[[nodiscard]] BodyRows rows_of(const model::System& system, const assembly::Assembled& assembled, std::size_t body);

/// True if an end of the element is on something that moves.
[[nodiscard]] bool is_on(const model::Element& element, const std::vector<bool>& moving);

/// A body on its elements with all other bodies held: K φ = ω² A φ in its rows, first its own, then the inner ones.
struct OwnSystem {
  numerics::DynamicMatrices matrices;
  /// Share of the kinetic energy in each coordinate at the centre of mass, along body axes: φᵀEφ / φᵀAφ, φ in the own
  /// rows. E is not symmetric.
  std::array<Eigen::MatrixXd, 6> energy;
};
[[nodiscard]] OwnSystem own_system(const model::Body& body, const assembly::Assembled& assembled, const BodyRows& rows);

/// Its modes, λ = ω² ascending, φᵀAφ = norm = ±1.
struct OwnModes {
  Eigen::VectorXd lambda, norm;
  Eigen::MatrixXd shapes;
};
[[nodiscard]] OwnModes own_modes(const OwnSystem& own);

// Characteristic quantities of an elastic suspension. Formulas and their limits: docs/suspension.md.

/// Axes about which a body rotates under a moment: free in space under an oscillating one, on its elements under a
/// constant one. Body frame.
struct RollAxes {
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< unit vector of the moment
  Eigen::Vector3d torque_roll_axis =
      Eigen::Vector3d::Zero();       ///< unit vector of J_C⁻¹ t; the line goes through the centre of mass
  spatial::Screw elastic_roll_axis;  ///< screw of K⁻¹(0, t); its point is the one nearest to the centre of mass
  double torsional_stiffness = 0;    ///< moment / rotation about its direction, no other motion constrained [N m/rad]
  double angle = 0;                  ///< between the two lines, 0 … π/2 [rad]
  double shortest_distance = 0;      ///< between the two lines [m]; for parallel lines the distance everywhere
  double distance_at_centre = 0;     ///< from the elastic roll axis to the centre of mass [m]
};

/// One undamped mode of the body on its elements.
struct BodyMode {
  std::optional<double> angular_frequency;  ///< [rad/s]; 0 for a rigid-body mode, empty if ω² < 0
  /// φ_j(Mφ)_j/φᵀAφ at the centre of mass along body axes, M = diag(m I, J_C); negative if products of inertia
  /// couple.
  spatial::Vector6 kinetic_energy_share = spatial::Vector6::Zero();
  double in_elements = 0;  ///< share of the elements' own mass; sums to 1 with the six
  int purest = 0;          ///< coordinate of the largest share, 0 … 5
  [[nodiscard]] double decoupling() const {
    return kinetic_energy_share(purest);
  }  ///< 1: a motion of one coordinate alone
};

/// One body on its elements with all other bodies fixed: elements to other bodies act as if to the ground.
struct BodySuspension {
  std::size_t body = 0;
  spatial::Matrix6 stiffness =
      spatial::Matrix6::Zero();  ///< at the pole, body frame; internal coordinates of elements are condensed statically
  /// Elastic centre from the pole, principal stiffnesses and axes, remaining coupling; empty for a constrained body,
  /// because its constraints hold it too.
  std::optional<elements::StiffnessProperties> elastic;
  double centre_distance = 0;  ///< from the elastic centre to the centre of mass [m]; with `elastic`
  std::vector<RollAxes>
      roll_axes;  ///< one per torque; empty if some rotation or translation is unrestrained, or the body is constrained
  std::vector<BodyMode> modes;     ///< ascending
  std::vector<std::string> notes;  ///< what was omitted or replaced, and why
};

/// The three axes of a body.
[[nodiscard]] inline std::vector<Eigen::Vector3d> body_axes() {
  return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
}

/// @param torques  directions of moments [any length > 0], frame of the body
/// @throws InvalidInput for a direction of no length
[[nodiscard]] BodySuspension body_suspension(const model::System& system, const assembly::Assembled& assembled,
                                             std::size_t body,
                                             const std::vector<Eigen::Vector3d>& torques = body_axes());

/// Separation of natural frequencies from each other and from given excitations.
struct FrequencySeparation {
  int mode = 0;                         ///< number, from 1
  double angular_frequency = 0;         ///< [rad/s], > 0
  std::optional<double> ratio_to_next;  ///< ω of the next mode / ω of this one, ≥ 1
  std::vector<double>
      excitation_ratio;  ///< excitation / natural frequency, one per excitation; above √2 the mode isolates
};
/// One row per mode that oscillates. @param excitations  angular frequencies [rad/s], > 0
[[nodiscard]] std::vector<FrequencySeparation> frequency_separation(const Modes& modes,
                                                                    const std::vector<double>& excitations = {});

}  // namespace trivet::modal
