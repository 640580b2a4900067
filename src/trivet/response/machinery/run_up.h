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
  Band speed;                    ///< of the shaft [rad/s], 0 ≤ from < to
  double min_prominence = 1e-6;  ///< see PeakOptions
  int points = 501;              ///< equally spaced speeds, at least 2, beside the critical ones and those around them
  double tall_from =
      0.01;  ///< height of a peak over the highest of its answer from which the curves are drawn through it
};

/// One order over the speeds of its run-up: all answers at ω = order · Ω.
struct OrderCurves {
  double order = 0;
  std::vector<Curve> curves;
};

/// A speed at which an answer to one order has a resonance peak.
struct CriticalSpeed {
  std::size_t curve = 0;
  double order = 0;
  double speed = 0;              ///< Ω [rad/s]
  double angular_frequency = 0;  ///< ω = order · Ω [rad/s]
  double amplitude = 0;          ///< of this order alone; infinite at an undamped natural frequency
  double prominence = 0;
  double relative_height =
      0;  ///< over the highest critical amplitude of this answer to any order; 0 beside an infinite one
  std::optional<int> nearest_mode;
};

/// One answer with all orders together.
struct Overall {
  std::string name;
  std::string unit;
  Eigen::VectorXd rms;        ///< √(Σ |y_k|² / 2): the orders differ in frequency
  Eigen::VectorXd bound;      ///< Σ |y_k| ≥ |y(t)|: as high as all orders can add up
  double highest_rms = 0;     ///< at the speeds of the grid; infinite with an undamped resonance among them
  double highest_rms_at = 0;  ///< Ω [rad/s]
};

struct RunUp {
  std::vector<double>
      speed;  ///< Ω [rad/s], ascending, with every finite peak of every order that is tall, and points around it
  std::vector<OrderCurves> orders;      ///< ascending order, all curves over `speed`
  std::vector<Overall> overall;         ///< per channel
  std::vector<CriticalSpeed> critical;  ///< all in the range; by curve, then ascending speed
  std::vector<double>
      undefined_at;  ///< Ω [rad/s] where an order meets an undamped resonance on the grid: its values are NaN there
  double worst_backward_error = 0;  ///< see SolutionCheck
};

/// Slow run-up: the steady response to each order at each shaft speed. Peaks lie where d|y_k|/dΩ = 0 exactly, the
/// growth of unbalance with Ω² included.
/// @throws foundation::InvalidInput without orders, for a range that is none, or less than two points
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

/// The line spectra of one curve at `spectra` speeds of the run-up, those nearest to an even spread; by speed, then
/// order.
[[nodiscard]] std::vector<WaterfallLine> waterfall(const RunUp& run_up, std::size_t curve, int spectra);

}  // namespace trivet::response
