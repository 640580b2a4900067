// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/pair_form.h"
#include "trivet/response/transient/exponential_step.h"

namespace trivet::response {

/// Loads of one course of an input: h = Σ force(:, m) u^(m) on the free coordinates, g = Σ ground(:, m) u^(m); columns
/// as in InputVector.
struct Drive {
  InputMatrix force;
  InputMatrix ground;
};

/// Number of derivatives of u that a result may contain, from the −2nd on.
inline constexpr Eigen::Index input_derivatives = 10;
using InputDerivatives = Eigen::Matrix<double, input_derivatives, 1>;
/// ∬u … u^(7), the higher ones from u‴ = −κ²u′.
[[nodiscard]] InputDerivatives all_derivatives(const InputVector& w, double kappa);

/// Results as linear functions of the state and of the inputs' derivatives (input_derivatives columns per course).
struct LinearRows {
  Eigen::MatrixXd on_state;
  Eigen::MatrixXd on_input;
};

/// One undamped mode with ω > 0, as needed for a transient.
struct StateMode {
  double angular_frequency = 0;     ///< [rad/s]
  Eigen::Index place = 0;           ///< index of its displacement in the state; its velocity is at place + massive
  std::vector<InputVector> forces;  ///< modal force per course
};

/// State equation ẋ = F x + Σ G w of A q̈ + B q̇ + K q = h. States: displacements of the massive coordinates (of their
/// modes, if the matrices are symmetric), their velocities, and the massless coordinates with dashpots; massless ones
/// without dashpot follow statically. States are scaled so that their squares are energies, and the stiffness of a
/// rigid-body mode is exactly 0.
class StateSpace {
 public:
  /// @throws foundation::NotComputable if a coordinate has neither mass, nor damping, nor stiffness of its own
  StateSpace(const numerics::DynamicMatrices& matrices, const std::vector<Drive>& courses);

  [[nodiscard]] const Eigen::MatrixXd& F() const { return F_; }
  [[nodiscard]] const InputMatrix& G(std::size_t course) const { return G_[course]; }
  [[nodiscard]] Eigen::Index size() const { return F_.rows(); }
  [[nodiscard]] Eigen::Index massive() const { return massive_; }
  /// States that do not act on each other; a single group unless decoupled.
  [[nodiscard]] const numerics::StateGroups& groups() const { return groups_; }
  /// The same system in states that do not act on each other, where a well-conditioned basis of them exists. Its modes
  /// have no place among these states.
  [[nodiscard]] StateSpace decoupled() const;
  [[nodiscard]] const std::vector<StateMode>& modes() const { return modes_; }

  /// Displacements of all free coordinates.
  [[nodiscard]] const LinearRows& displacements() const { return displacements_; }
  /// Time derivative of rows, valid between the corners of the inputs.
  [[nodiscard]] LinearRows derivative(const LinearRows& rows) const;
  /// State for given displacements and velocities of the free coordinates.
  [[nodiscard]] Eigen::VectorXd state(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) const;
  /// Jump of the state at jumps of u and u̇: an impulse through dampers (and masses) on a moving ground.
  [[nodiscard]] Eigen::VectorXd jump(std::size_t course, const InputVector& jump) const;

 private:
  Eigen::Index massive_ = 0;
  Eigen::MatrixXd F_;
  numerics::StateGroups groups_;
  std::vector<InputMatrix> G_;
  LinearRows displacements_;
  Eigen::MatrixXd from_displacement_, from_velocity_;  ///< state of q and of q̇
  std::vector<StateMode> modes_;
};

/// Coordinates of the state: q = T (p, z, y), p with mass, z without mass but with dashpots, y with springs alone.
/// Matrices are TᵀAT and so on.
struct StateBasis {
  Eigen::MatrixXd T;
  Eigen::Index massive = 0, lagging = 0, following = 0;  ///< numbers of p, z, y
  bool modal = false;                                    ///< p are amplitudes of undamped modes
  Eigen::MatrixXd A;                                     ///< massive × massive
  Eigen::MatrixXd B, K;              ///< of all; with modes, K is exactly diagonal, and exactly 0 for a rigid-body mode
  Eigen::MatrixXd from_coordinates;  ///< (p, z, y) from q
  Eigen::VectorXd speed;             ///< per p: the natural frequency, or a scale in its place [rad/s]
};

/// @throws foundation::NotComputable if a coordinate has neither mass nor stiffness, or is coupled by damping without
/// damping of its own
[[nodiscard]] StateBasis state_basis(const numerics::DynamicMatrices& matrices);

}  // namespace trivet::response
