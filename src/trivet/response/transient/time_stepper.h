// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/response/transient/exact_steps.h"
#include "trivet/response/transient/input_course.h"
#include "trivet/response/transient/state_space.h"
#include "trivet/response/transient/time_grid.h"

namespace trivet::response {

/// State of the time stepping just after all corners at `time`.
struct StepperState {
  double time = 0;
  Eigen::VectorXd x;
  std::vector<InputCourse::Place> places;  ///< per course
};

/// Advances a state in time without truncation error. Times closer than `resolution` are equal. Not copyable, not
/// thread-safe.
class TimeStepper {
 public:
  TimeStepper(const StateSpace& space, const std::vector<InputCourse>& courses, double step, double resolution);

  [[nodiscard]] double resolution() const { return resolution_; }
  [[nodiscard]] double next_corner(const StepperState& at) const;
  /// Advances to a time at most one step later with no corner before it; a corner at that time is not yet applied.
  void advance_to_corner(StepperState& at, double to);
  /// Applies the corners at this time; the state jumps if the ground does.
  void apply_corners(StepperState& at) const;
  /// True if the state jumps at jumps or corners of this input.
  [[nodiscard]] bool state_jumps(std::size_t course) const { return !space_.G(course).rightCols<2>().isZero(0); }
  /// Advances from one point of the grid over as many whole steps as possible (sample_whole_steps), at most by the
  /// columns of w. Column i of the states, from 1 on, is the state after i steps, and column i of w the inputs of all
  /// courses before the next one.
  /// @param states  column 0 holds the state of `at`
  /// @return the number of steps
  Eigen::Index take_whole_steps(StepperState& at, const TimeGrid& grid, Eigen::Index point,
                                const std::vector<int>& held, Eigen::Ref<Eigen::MatrixXd> states,
                                Eigen::Ref<Eigen::MatrixXd> w);
  /// The state x at a time whose corners are applied.
  [[nodiscard]] StepperState state_at(double time, const Eigen::VectorXd& x) const;
  /// Advances to any later time and applies the corners on the way and at its end.
  void advance(StepperState& at, double to);
  /// w of every course, stacked, with derivatives up to the seventh.
  void inputs(const StepperState& at, Eigen::Ref<Eigen::VectorXd> derivatives) const;

 private:
  void apply_step(StepperState& at, std::size_t level);
  void apply_series(StepperState& at, double duration);
  void find_inputs(const StepperState& at, std::size_t level);

  /// Γ of one course and κ, per level, and its columns that are not zero.
  struct Gamma {
    std::vector<InputMatrix> levels;
    std::vector<Eigen::Index> columns;
  };
  const Gamma& gamma(std::size_t course, std::size_t kappa);

  const StateSpace& space_;
  const std::vector<InputCourse>& courses_;
  double resolution_;
  ExactSteps steps_;
  std::vector<std::vector<Gamma>> gamma_;    ///< per course and κ; filled when first needed
  std::vector<numerics::StepInput> inputs_;  ///< of the steps taken at present
  Eigen::MatrixXd two_;                      ///< states before and after a single step
  Eigen::VectorXd w_, next_, term_;
  std::vector<InputVector> own_;
};

}  // namespace trivet::response
