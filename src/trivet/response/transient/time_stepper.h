// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/numerics/linalg/pair_form.h"
#include "trivet/numerics/recurrence/pair_steps.h"
#include "trivet/response/transient/exponential_step.h"
#include "trivet/response/transient/input_course.h"
#include "trivet/response/transient/state_space.h"
#include "trivet/response/transient/time_grid.h"

namespace trivet::response {

/// Inputs of one course at the points of a grid from which whole steps can be taken: no corner is between a point and
/// the next one, κ is constant and no derivative in `held` (bit m for the mth) jumps.
/// @param w  column i: ∬u … ü at the ith point from `point` on; its columns are the largest number of steps
/// @param place  of the course at `point`
/// @return the number of steps
[[nodiscard]] Eigen::Index sample_whole_steps(const InputCourse& course, const TimeGrid& grid, Eigen::Index point,
                                              int held, InputCourse::Place place,
                                              Eigen::Ref<Eigen::Matrix<double, 5, Eigen::Dynamic>> w);

/// Exact steps of all states of a system, group by group: the cost of a pair does not depend on the number of others.
class ExactSteps {
 public:
  /// @param largest_kappa  largest κ of all inputs [rad/s]
  ExactSteps(const StateSpace& space, double step, double largest_kappa);

  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] std::size_t levels() const { return levels_; }
  /// Norm of F, or the largest κ if it is larger [rad/s].
  [[nodiscard]] double fastest() const { return fastest_; }
  /// Γ(κ, step/2^level) of all states, one per level.
  [[nodiscard]] std::vector<InputMatrix> input(const InputMatrix& G, double kappa) const;

  /// One step of step/2^level per column of w: column 0 of the states is given, the next ones are computed.
  /// @param inputs  columns of Γ of this level and their rows of w
  void take(std::size_t level, const std::vector<numerics::StepInput>& inputs,
            const Eigen::Ref<const Eigen::MatrixXd>& w, Eigen::Ref<Eigen::MatrixXd> states) const;
  /// F x.
  void rate(const Eigen::VectorXd& x, Eigen::VectorXd& result) const;

 private:
  [[nodiscard]] Eigen::ArrayXXd pair_matrix(std::size_t level) const;

  const Eigen::MatrixXd& F_;
  const numerics::StateGroups& groups_;
  double step_, fastest_;
  std::size_t levels_ = 0;
  std::vector<ExponentialStep> pairs_, dense_;  ///< one per pair, and one per dense group
  std::vector<Eigen::ArrayXXd> pair_matrices_;  ///< per level: a, b, c, d of all pairs, as in numerics::PairSteps
  Eigen::ArrayXXd pair_rates_;                  ///< the same of F
};

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
