// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/response/transient/exponential_step.h"

namespace trivet::response {

/// What one course of an input drives: h = Σ force(:, m) u^(m) on the free coordinates, g = Σ ground(:, m) u^(m);
/// columns as in InputVector.
struct Drive {
  InputMatrix force;
  InputMatrix ground;
};

/// Derivatives of u that an answer may hold: from the −2nd on.
inline constexpr Eigen::Index input_derivatives = 10;
using InputDerivatives = Eigen::Matrix<double, input_derivatives, 1>;
/// ∬u … u^(7), the higher ones by u‴ = −κ²u′.
[[nodiscard]] InputDerivatives all_derivatives(const InputVector& w, double kappa);

/// Answers as linear functions of the state and of the inputs' derivatives (input_derivatives columns per course).
struct LinearRows {
  Eigen::MatrixXd on_state;
  Eigen::MatrixXd on_input;
};

/// One undamped mode with ω > 0, as far as a transient asks.
struct StateMode {
  double angular_frequency = 0;     ///< [rad/s]
  Eigen::Index place = 0;           ///< its displacement in the state; its velocity stands at place + massive
  std::vector<InputVector> forces;  ///< modal force per course
};

/// ẋ = F x + Σ G w of A q̈ + B q̇ + K q = h. States: displacements of the massive coordinates (of their modes, where the
/// matrices are symmetric), their velocities, and the massless coordinates that a dashpot holds; massless ones without
/// dashpot follow statically. All are scaled so that their squares are energies, and a rigid motion is free of
/// stiffness exactly.
class StateSpace {
 public:
  /// @throws foundation::NotComputable if a coordinate has neither mass, nor damping, nor stiffness of its own
  StateSpace(const numerics::DynamicMatrices& matrices, const std::vector<Drive>& courses);

  [[nodiscard]] const Eigen::MatrixXd& F() const { return F_; }
  [[nodiscard]] const InputMatrix& G(std::size_t course) const { return G_[course]; }
  [[nodiscard]] Eigen::Index size() const { return F_.rows(); }
  [[nodiscard]] Eigen::Index massive() const { return massive_; }
  [[nodiscard]] const std::vector<StateMode>& modes() const { return modes_; }

  /// Rows of all free coordinates.
  [[nodiscard]] const LinearRows& displacements() const { return displacements_; }
  /// d/dt of rows, while no input has a corner.
  [[nodiscard]] LinearRows derivative(const LinearRows& rows) const;
  /// State of given displacements and velocities of the free coordinates.
  [[nodiscard]] Eigen::VectorXd state(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) const;
  /// What the state jumps by where u and u̇ do: an impulse through dampers (and masses) on a moving ground.
  [[nodiscard]] Eigen::VectorXd jump(std::size_t course, const InputVector& jump) const;

 private:
  Eigen::Index massive_ = 0;
  Eigen::MatrixXd F_;
  std::vector<InputMatrix> G_;
  LinearRows displacements_;
  Eigen::MatrixXd from_displacement_, from_velocity_;  ///< state of q and of q̇
  std::vector<StateMode> modes_;
};

}  // namespace trivet::response
