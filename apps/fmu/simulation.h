// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "fmu/linear_model.h"
#include "fmu/step_matrices.h"
#include "fmu/variable.h"

namespace trivet::fmu {

/// Everything that changes during a simulation.
struct SimulationState {
  double time = 0;                                             ///< [s]
  double stop_time = std::numeric_limits<double>::infinity();  ///< last time that a step may reach [s]
  double behind = 0;            ///< time that the steps taken are shorter than the steps wanted, by rounding [s]
  bool slopes_are_used = true;  ///< by a step that has ended: they are zero for the next one
  std::vector<double> states;
  std::vector<double> inputs;
  std::vector<double> slopes;  ///< of the inputs, per second
};

/// One simulation of a model. All functions throw std::runtime_error and change nothing if a reference is unknown, a
/// number is not finite or a variable cannot be used as requested.
class Simulation {
 public:
  /// The largest order of derivatives of inputs and outputs that is not ignored.
  static constexpr int largest_order = 1;

  explicit Simulation(LinearModel model);
  [[nodiscard]] const LinearModel& model() const { return model_; }
  [[nodiscard]] const SimulationState& state() const { return state_; }
  /// @param state  with the sizes of this model
  void set_state(SimulationState state) { state_ = std::move(state); }
  /// Initial states, inputs zero, time zero.
  void reset();

  void set_experiment(double start_time, double stop_time);
  void set_time(double time);
  void set_states(std::span<const double> states);
  /// Sets inputs, and also states if these may be set.
  void set(std::span<const ValueReference> references, std::span<const double> values, bool states_may_be_set);
  void get(std::span<const ValueReference> references, std::span<double> values) const;
  void get_derivatives(std::span<double> values) const;

  /// Sets the slopes of inputs for the next step; the other slopes are zero.
  void set_slopes(std::span<const ValueReference> references, std::span<const int> orders,
                  std::span<const double> values);
  /// Derivatives of outputs with respect to time; 0 for orders above 1. [1/s]
  void get_output_slopes(std::span<const ValueReference> references, std::span<const int> orders,
                         std::span<double> values) const;

  /// Advances the states exactly, for inputs that follow their slopes from their present values.
  /// @param from  the present time, to a thousandth of the step; the next one is from + step [s]  @param step  [s], > 0
  void advance(double from, double step);
  /// Number of matrix exponentials computed so far.
  [[nodiscard]] std::size_t exponentials() const { return steps_.computed(); }

  /// Partial derivative of an output or of the derivative of a state by an input, a state or time.
  [[nodiscard]] double partial_derivative(ValueReference unknown, ValueReference known) const;

 private:
  [[nodiscard]] double value(Variable variable) const;

  LinearModel model_;
  SimulationState state_;
  StepMatrices steps_;
};

}  // namespace trivet::fmu
