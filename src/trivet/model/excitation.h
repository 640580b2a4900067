// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <complex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "trivet/excitation/engine_orders.h"
#include "trivet/excitation/signal.h"
#include "trivet/excitation/spectrum.h"
#include "trivet/spatial/types.h"

namespace trivet::model {

/// A plane wave along the ground: a place r moves like the ground origin, direction·r / speed later.
struct Wave {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector, ground frame
  double speed = 0;                                      ///< [m/s]
};

/// Point, direction and phase of an excitation: a force and moment on a body, or a motion of the ground.
struct Action {
  using Amplitude = Eigen::Matrix<std::complex<double>, 6, 1>;

  std::optional<std::size_t> body;  ///< empty: the ground moves
  Eigen::Vector3d at =
      Eigen::Vector3d::Zero();  ///< of the force, body frame; of a rigid motion of the ground, ground frame [m]
  /// Force [N] and moment [N m], body axes; or translation [m, m/s, m/s²] and rotation [rad, …], ground axes.
  /// Multiplied by the course of the excitation.
  Amplitude amplitude = Amplitude::Zero();
  double delay = 0;  ///< [s]
  std::vector<std::size_t>
      elements;  ///< their ground ends move, each about its own reference point; empty: the whole ground about `at`
  std::optional<Wave> wave;  ///< for a moving ground; each ground end then moves separately
  int derivative = 0;        ///< a motion is given as 0 displacement, 1 velocity, 2 acceleration
};

/// Re(amplitude · e^{iωt}), amplitude ∝ ω^power_of_frequency: 0, or 2 for an unbalance.
struct Harmonic {
  int power_of_frequency = 0;
};

/// Forces and moments at multiples of a shaft speed, body axes; the amplitude of the action is not used.
struct Orders {
  std::vector<excitation::Order> list;
};

/// Stationary random excitation: `spectrum` is that of the factor on the amplitude of the action.
struct Random {
  excitation::Spectrum spectrum;
  /// Coherence with another random excitation, by name; excitations that are not listed are uncorrelated.
  struct Partner {
    std::string other;
    excitation::Coherence coherence;
  };
  std::vector<Partner> partners;
};

/// One time history that starts from rest: u(t) times the amplitude of the action, which is real.
struct History {
  excitation::Signal signal;
};

using Course = std::variant<Harmonic, Orders, Random, History>;

struct Excitation {
  std::string name;
  Action action;
  Course course;
  double service_speed = 0;  ///< of the rotor of an unbalance [rad/s]; 0: not given
};

/// True if the excitation is among those selected by name; an empty selection means all.
[[nodiscard]] inline bool is_selected(const Excitation& excitation, const std::vector<std::string>& selected) {
  return selected.empty() || std::ranges::find(selected, excitation.name) != selected.end();
}

}  // namespace trivet::model
