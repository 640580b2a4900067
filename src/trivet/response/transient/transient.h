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

/// One signal u(t) and what it drives: forces of power 0; motions of the ground of power 0, or −1 and −2 where u is
/// their velocity or acceleration. All with their delays, and real: a phase has no meaning in time.
struct TimeInput {
  std::string name;  ///< for messages
  excitation::Signal signal;
  assembly::Loading loading;  ///< assembly::loading(assembled, action)
};

/// Displacements and velocities of the free coordinates, all of the layout.
struct InitialState {
  Eigen::VectorXd displacement;
  Eigen::VectorXd velocity;
};

/// Bodies (free coordinates in their order, the first rows of the layout) displaced and moving; foundations and
/// internal coordinates of elements follow as if the bodies had been held like that for long.
[[nodiscard]] InitialState initial_state(const assembly::Assembled& assembled, const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& velocity);

struct TransientOptions {
  double from = 0;  ///< [s]
  std::optional<double>
      to;  ///< [s]; by default ten periods of the slowest mode that is excited after the last corner of an input
  std::optional<double> step;  ///< of the answers [s]; by default 1/20 of the period of the fastest mode that is
                               ///< excited, and of each sine
  Eigen::Index most_points =
      100'000;  ///< where the step is not given: it is made coarser (and warned) rather than give more
  std::optional<InitialState>
      initial;  ///< just before `from`; without it the system rests in its equilibrium until the first input begins
  bool nearest_linear_system =
      false;  ///< take frequency-dependent elements by their nearest linear system instead of refusing them (warned)
};

struct Extreme {
  double value = 0;
  double time = 0;  ///< [s]
};

/// One answer over time, SI, counted from the position of rest.
struct TimeCurve {
  std::string name;
  std::string unit;
  Eigen::VectorXd values;  ///< at a jump the value after it
  Extreme largest,
      smallest;    ///< also between the points: the exact motion is searched there, and both sides of every jump
  double rms = 0;  ///< over the whole time, by the trapezoidal rule over the points
};

struct TransientResponse {
  Eigen::VectorXd time;  ///< [s], uniform
  std::vector<TimeCurve> curves;
  foundation::Problems warnings;
};

/// A q̈ + B q̇ + K q = Q(t) − (K_fg g + B_fg ġ + A_fg g̈), exact at every point of time: the matrix exponential of the
/// state equations together with the equations of the inputs, each piece of which obeys u‴ = −κ²u′. Corners and jumps
/// act at their own times, and a jump of the ground acts through its dampers as the impulse that it is. A rigid
/// foundation given by its velocity or acceleration is followed by the coordinates, so that answers against it keep
/// their digits however far it drifts. Method and limits: docs/transient.md.
/// @throws foundation::NotComputable with the reason: loss factors, frequency-dependent elements, a motion that
/// outgrows all numbers
/// @throws foundation::InvalidInput for signals, times or loads out of range
[[nodiscard]] TransientResponse transient_response(const model::System& system, const assembly::Assembled& assembled,
                                                   const std::vector<assembly::Channel>& channels,
                                                   const std::vector<TimeInput>& inputs,
                                                   const TransientOptions& options = {},
                                                   const foundation::Progress& progress = {});

}  // namespace trivet::response
