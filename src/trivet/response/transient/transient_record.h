// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/response/transient/time_grid.h"
#include "trivet/response/transient/time_stepper.h"
#include "trivet/response/transient/transient.h"
#include "trivet/response/transient/transient_extremes.h"

namespace trivet::response {

/// Steps over the grid and stores the answers: values at its points, extremes at the points and on both sides of every
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
  [[nodiscard]] bool answers_jump(const StepperState& state, double corner) const;
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
