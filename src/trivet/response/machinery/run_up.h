// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/modal/roots.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::response {

/// All excitation at one multiple of the shaft speed Ω, as a loading over ω = order · Ω: a force proportional to Ω² is
/// proportional to ω²/order².
struct OrderLoading {
  double order = 0;
  assembly::Loading loading;
  std::vector<std::string> excitations;  ///< that act at this order
};

/// Orders of all excitations that depend on a shaft speed, or of those named, ascending; equal orders act together. A
/// harmonic force that grows with ω² (an unbalance) is order 1. All have the same Ω.
/// @throws foundation::InvalidInput for a name that is not such an excitation, or an order ≤ 0
[[nodiscard]] std::vector<OrderLoading> order_loadings(const model::System& system,
                                                       const assembly::Assembled& assembled,
                                                       const std::vector<std::string>& selected = {});

struct RunUpOptions {
  assembly::Band speed;          ///< of the shaft [rad/s], 0 ≤ from < to
  double min_prominence = 1e-6;  ///< see PeakOptions
  int points = 501;  ///< equally spaced speeds, at least 2, in addition to critical speeds and points around them
  double tall_from =
      0.01;  ///< least height of a peak, relative to the highest of its result, at which the speed grid includes it
};

/// Responses to one order over the speeds of the run-up, at ω = order · Ω.
struct OrderCurves {
  double order = 0;
  std::vector<Curve> curves;
};

/// A speed at which the response to one order has a resonance peak.
struct CriticalSpeed {
  std::size_t curve = 0;
  double order = 0;
  double speed = 0;              ///< Ω [rad/s]
  double angular_frequency = 0;  ///< ω = order · Ω [rad/s]
  double amplitude = 0;          ///< of this order alone; infinite at an undamped natural frequency
  double prominence = 0;
  double relative_height = 0;  ///< amplitude / highest critical amplitude of this result over all orders; 0 for a
                               ///< finite one if that is infinite
  std::optional<int> nearest_mode;
};

/// One result under all orders together.
struct Overall {
  std::string name;
  std::string unit;
  Eigen::VectorXd rms;        ///< √(Σ |y_k|² / 2): the orders differ in frequency
  Eigen::VectorXd bound;      ///< Σ |y_k| ≥ |y(t)|: all orders in phase
  double highest_rms = 0;     ///< over the speeds of the grid; infinite with an undamped resonance in the range
  double highest_rms_at = 0;  ///< Ω [rad/s]
};

struct RunUp {
  std::vector<double> speed;  ///< Ω [rad/s], ascending; includes every finite peak of every order above `tall_from`,
                              ///< and points around it
  std::vector<OrderCurves> orders;      ///< ascending order, all curves over `speed`
  std::vector<Overall> overall;         ///< per channel
  std::vector<CriticalSpeed> critical;  ///< all in the range; by curve, then ascending speed
  std::vector<double>
      undefined_at;  ///< Ω [rad/s] of grid points at an undamped resonance of an order: its values are NaN there
  double worst_backward_error = 0;  ///< see SolutionCheck
};

/// Slow run-up: the steady response to each order at each shaft speed. Peaks are exact roots of d|y_k|/dΩ = 0,
/// including the growth of unbalance with Ω².
/// @throws foundation::InvalidInput without orders, unless 0 ≤ from < to, or for fewer than two points
[[nodiscard]] RunUp run_up(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                           const std::vector<OrderLoading>& order_loadings, const modal::Modes& modes,
                           const modal::Roots& roots, const RunUpOptions& options,
                           const foundation::Progress& progress = {});

/// One line of the spectrum at one speed.
struct WaterfallLine {
  double speed = 0;              ///< Ω [rad/s]
  double angular_frequency = 0;  ///< ω = order · Ω [rad/s]
  double order = 0;
  double amplitude = 0;
};

/// Line spectra of one curve at up to `spectra` speeds of the run-up, those nearest to equal spacing; sorted by speed,
/// then order.
[[nodiscard]] std::vector<WaterfallLine> waterfall(const RunUp& run_up, std::size_t curve, int spectra);

/// One natural frequency, a horizontal line of the diagram: the model does not depend on the shaft speed.
struct NaturalLine {
  double angular_frequency = 0;  ///< Im λ of the damped root [rad/s]
  double damping_ratio = 0;
  std::optional<int> nearest_mode;  ///< see modal::Root
};

/// Intersection of an order line with a natural frequency within the speed range: Ω = Im λ / order.
struct Interference {
  std::size_t line = 0;  ///< index in Campbell::natural
  double order = 0;
  double speed = 0;              ///< Ω [rad/s]
  double angular_frequency = 0;  ///< [rad/s]
  std::optional<int> mode;       ///< mode of the natural line
  /// Modal force share |φᵀF|² / Σ |φ_iᵀF|² of that mode with the force F of the order at this speed: 0 … 1, sum over
  /// all modes 1. With φᵀAφ = 1 it is the share of the kinetic energy that a short impulse F gives the mode. Empty
  /// without a mode, or if the order excites no mode.
  std::optional<double> modal_force_share;
  bool excited = false;  ///< modal_force_share ≥ `excited_from`
};

/// Modes with a smaller modal force share (a thousandth of the amplitude) count as not excited.
inline constexpr double excited_from = 1e-6;

/// Campbell diagram of a system without gyroscopic terms.
struct Campbell {
  assembly::Band speed;  ///< [rad/s]
  std::vector<double> orders;
  std::vector<NaturalLine> natural;  ///< ascending
  std::vector<Interference> points;  ///< ascending speed
};

/// @throws foundation::InvalidInput unless 0 ≤ from < to
[[nodiscard]] Campbell campbell(const std::vector<OrderLoading>& order_loadings, const modal::Modes& modes,
                                const modal::Roots& roots, const assembly::Band& speed);

}  // namespace trivet::response
