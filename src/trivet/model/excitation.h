// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "trivet/excitation/cross_spectrum.h"
#include "trivet/excitation/engine_orders.h"
#include "trivet/excitation/signal.h"
#include "trivet/excitation/spectrum.h"
#include "trivet/spatial/types.h"

namespace trivet::model {

/// A plane wave along the ground: what happens at a place r happens there direction·r / speed later than at the ground
/// origin.
struct Wave {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector, ground frame
  double speed = 0;                                      ///< [m/s]
};

/// Where something acts, in which directions, and with which phases: a force and moment on a body, or a motion of the
/// ground.
struct Action {
  using Amplitude = Eigen::Matrix<std::complex<double>, 6, 1>;

  std::optional<std::size_t> body;  ///< none: the ground moves
  Eigen::Vector3d at =
      Eigen::Vector3d::Zero();  ///< of the force, body frame; of a rigid motion of the ground, ground frame [m]
  /// Force [N] and moment [N m], body axes; or translation [m, m/s, m/s²] and rotation [rad, …], ground axes. Times
  /// what its course says.
  Amplitude amplitude = Amplitude::Zero();
  double delay = 0;  ///< [s]
  std::vector<std::size_t>
      elements;  ///< whose ground ends move, each about its own reference point; empty: the whole ground about `at`
  std::optional<Wave> wave;  ///< of a moving ground; each ground end then moves for itself
  int derivative = 0;        ///< of a motion: 0 displacement, 1 velocity, 2 acceleration is given
};

/// Re(amplitude · e^{iωt}), amplitude ∝ ω^power_of_frequency: 0, or 2 for an unbalance.
struct Harmonic {
  int power_of_frequency = 0;
};

/// Forces and moments at multiples of a shaft speed, body axes; the amplitude of the action is not used.
struct Orders {
  std::vector<excitation::Order> list;
};

/// Stationary random with one spectral density of what the amplitude of the action multiplies.
struct Random {
  excitation::Spectrum spectrum;
  /// How it goes with other random excitations (by name); uncorrelated with all others.
  struct Partner {
    std::string other;
    excitation::Coherence coherence;
  };
  std::vector<Partner> partners;
};

/// One run of time from rest: u(t) times the amplitude of the action, which is real.
struct History {
  excitation::Signal signal;
};

using Course = std::variant<Harmonic, Orders, Random, History>;

/// Something that drives the system.
struct Excitation {
  std::string name;
  Action action;
  Course course;
};

}  // namespace trivet::model
