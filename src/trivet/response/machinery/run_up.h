// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/response/machinery/order_loading.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::response {

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

}  // namespace trivet::response
