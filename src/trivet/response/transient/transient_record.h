// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"
#include "trivet/numerics/recurrence/rows_over_time.h"
#include "trivet/response/transient/input_course.h"
#include "trivet/response/transient/state_space.h"
#include "trivet/response/transient/time_grid.h"
#include "trivet/response/transient/time_stepper.h"
#include "trivet/response/transient/transient.h"

namespace trivet::response {

/// Motion in blocks of `every` points: where each block starts, and bounds of each curve in it.
struct TimeBlocks {
  Eigen::Index every = 1;
  Eigen::MatrixXd states;                                 ///< one column per block: the state at its first point
  std::vector<std::vector<numerics::RowBlock>> of_curve;  ///< per curve and block
};

/// Raises the extremes at the points and corners to those of the motion between the points: steps around the highest
/// points are repeated, and zeros of the derivative are searched in them. Exact to about 1e-9 if the fastest excited
/// motion has at least four points per period; a coarser grid may miss an extreme (with a warning).
/// @param row    output row of the result
/// @param index  of the result
void search_between_points(TimeStepper& stepper, const StateSpace& space, const LinearRows& row, std::size_t index,
                           const TimeGrid& grid, const TimeBlocks& blocks, const foundation::Progress& progress,
                           TimeCurve& curve);

/// Results, one row each, as linear functions of the state and of the inputs.
[[nodiscard]] LinearRows channel_rows(const StateSpace& space, const std::vector<assembly::Channel>& channels,
                                      const std::vector<Drive>& courses);

/// Columns of `on_input` that are not zero.
[[nodiscard]] std::vector<Eigen::Index> used_inputs(const LinearRows& rows);

/// Warns of results that contain the derivative of a jump of an input: an impulse of zero duration, which no curve
/// shows.
void warn_of_impulses(const LinearRows& rows, const std::vector<assembly::Channel>& channels,
                      const std::vector<InputCourse>& courses, const std::vector<std::string>& names,
                      foundation::Problems& warnings);

/// Steps over the grid and stores the channels: values at its points, extremes at the points and on both sides of every
/// jump.
class TransientRecord {
 public:
  TransientRecord(TimeStepper& stepper, const std::vector<InputCourse>& courses, LinearRows rows, const TimeGrid& grid);

  /// Runs from the first point, the time of `state`, to the last.
  /// @throws foundation::NotComputable if the motion leaves the range of numbers
  void run(StepperState state, const foundation::Progress& progress);

  [[nodiscard]] const TimeBlocks& blocks() const { return blocks_; }
  /// Values and extremes of the results, without names.
  [[nodiscard]] std::vector<TimeCurve> release_curves() { return std::move(curves_); }

 private:
  /// States, and below them the used inputs, at the points of one block, one column per point.
  struct TimeSamples {
    Eigen::Index points = 0;
    Eigen::MatrixXd X;
    Eigen::MatrixXd w;  ///< ∬u … ü of all courses
  };
  void add_block(StepperState& state, Eigen::Index first, TimeSamples& samples);
  void add_inputs(Eigen::Index begin, Eigen::Index count, TimeSamples& samples) const;
  void to_next_point(StepperState& state, double to);
  [[nodiscard]] bool channels_jump(const StepperState& state, double corner) const;
  void note(const StepperState& state);
  void keep(const numerics::RowsOverTime& values, Eigen::Index first, Eigen::Index count);
  void add_extremes_at_points();

  TimeStepper& stepper_;
  const std::vector<InputCourse>& courses_;
  LinearRows rows_;
  const TimeGrid& grid_;
  std::vector<int> held_;  ///< per course: bit m if results jump with the mth derivative of its signal
  std::vector<TimeCurve> curves_;
  TimeBlocks blocks_;
  std::vector<Eigen::Index> used_;  ///< inputs that results contain
  std::vector<double> kappas_;      ///< per course, during whole steps
  Eigen::VectorXd inputs_;
};

}  // namespace trivet::response
