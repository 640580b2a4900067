// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/excitation/signal.h"
#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::response {

/// One signal u(t) and its loading: forces of power 0; motions of the ground of power 0, or −1 and −2 if u is their
/// velocity or acceleration. With their delays, and real: a phase has no meaning in time.
struct TimeInput {
  std::string name;  ///< for messages
  excitation::Signal signal;
  assembly::Loading loading;  ///< assembly::loading(assembled, action)
};

/// Displacements and velocities of all free coordinates of the layout.
struct InitialState {
  Eigen::VectorXd displacement;
  Eigen::VectorXd velocity;
};

/// State with displaced and moving bodies (free coordinates in their order, the first rows of the layout); foundations
/// and internal coordinates of elements follow statically.
[[nodiscard]] InitialState initial_state(const assembly::Assembled& assembled, const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& velocity);

struct TransientOptions {
  double from = 0;  ///< [s]
  std::optional<double>
      to;  ///< [s]; by default ten periods of the slowest excited mode after the last corner of an input
  std::optional<double>
      step;  ///< of the output [s]; by default 1/20 of the period of the fastest excited mode, and of each sine
  Eigen::Index most_points =
      100'000;  ///< limit if the step is not given: the step is then made coarser (with a warning)
  std::optional<InitialState>
      initial;  ///< just before `from`; without it the system is at rest in equilibrium until the first input begins
  bool nearest_linear_system = false;  ///< replace frequency-dependent elements by their nearest linear system (with a
                                       ///< warning) instead of rejecting them
};

struct Extreme {
  double value = 0;
  double time = 0;  ///< [s]
};

/// One result over time, SI, relative to the position of rest.
struct TimeCurve {
  std::string name;
  std::string unit;
  Eigen::VectorXd values;  ///< at a jump the value after it
  Extreme largest,
      smallest;    ///< also between the points, from the exact motion, and on both sides of every jump
  double rms = 0;  ///< over the whole time, by the trapezoidal rule over the points
};

struct TransientResponse {
  Eigen::VectorXd time;  ///< [s], uniform
  std::vector<TimeCurve> curves;
  foundation::Problems warnings;
};

/// Transient response of A q̈ + B q̇ + K q = Q(t) − (K_fg g + B_fg ġ + A_fg g̈), exact at every point of time: the matrix
/// exponential of the state equations together with the equations of the inputs, each piece of which obeys u‴ = −κ²u′.
/// Corners and jumps act at their own times, and a jump of the ground acts through its dampers as an impulse. If a
/// rigid motion of the ground is given by its velocity or acceleration, the coordinates move with it, so that results
/// relative to it keep their digits however far it drifts. Method and limits: docs/transient.md.
/// @throws foundation::NotComputable with the reason: loss factors, frequency-dependent elements, a motion beyond the
/// range of numbers
/// @throws foundation::InvalidInput for signals, times or loads out of range
[[nodiscard]] TransientResponse transient_response(const model::System& system, const assembly::Assembled& assembled,
                                                   const std::vector<assembly::Channel>& channels,
                                                   const std::vector<TimeInput>& inputs,
                                                   const TransientOptions& options = {},
                                                   const foundation::Progress& progress = {});

}  // namespace trivet::response
