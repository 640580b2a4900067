// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "trivet/spatial/types.h"

namespace trivet::model {

/// A plane wave along the ground: what happens at a place r happens there direction·r / speed later than at the ground origin.
struct Wave {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector, ground frame
  double speed = 0;                                      ///< [m/s]
};

/// Where something acts, in which directions, and with which phases: a force and moment on a body, or a motion of the ground.
struct Action {
  using Amplitude = Eigen::Matrix<std::complex<double>, 6, 1>;

  std::optional<std::size_t> body;               ///< none: the ground moves
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< of the force, body frame; of a rigid motion of the ground, ground frame [m]
  /// Force [N] and moment [N m], body axes; or translation [m, m/s, m/s²] and rotation [rad, …], ground axes. Times what its course says.
  Amplitude amplitude = Amplitude::Zero();
  double delay = 0;                              ///< [s]
  std::vector<std::size_t> elements;             ///< whose ground ends move, each about its own reference point; empty: the whole ground about `at`
  std::optional<Wave> wave;                      ///< of a moving ground; each ground end then moves for itself
  int derivative = 0;                            ///< of a motion: 0 displacement, 1 velocity, 2 acceleration is given
};

/// Re(amplitude · e^{iωt}), amplitude ∝ ω^power_of_frequency: 0, or 2 for an unbalance.
struct Harmonic {
  int power_of_frequency = 0;
};

using Course = std::variant<Harmonic>;

/// Something that drives the system.
struct Excitation {
  std::string name;
  Action action;
  Course course;
};

}  // namespace trivet::model
