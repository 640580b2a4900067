// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fmu/shown_number.h"

namespace trivet::fmu {
namespace {

using Kind = Variable::Kind;

[[noreturn]] void refuse(const std::string& reason) { throw std::runtime_error(reason); }

void check_finite(double value, const std::string& what) {
  if (!std::isfinite(value)) refuse(what + " is " + shown(value) + ", but must be a finite number");
}

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// The variables of these references, which must all have this kind.
std::vector<std::size_t> indices(const LinearModel& model, std::span<const ValueReference> references, Kind kind,
                                 const std::string& rule) {
  std::vector<std::size_t> indices;
  for (const ValueReference reference : references) {
    const Variable found = variable(model, reference);
    if (found.kind != kind) refuse(name(found) + ": " + rule);
    indices.push_back(found.index);
  }
  return indices;
}

void check_orders(std::span<const int> orders) {
  if (std::ranges::any_of(orders, [](int order) { return order < 1; })) refuse("the order of a derivative is below 1");
}

/// Sum of two matrices times two vectors, one row of them.
double row_sum(const Matrix& a, std::span<const double> x, const Matrix& b, std::span<const double> u,
               std::size_t row) {
  return dot(a.row(row), x) + dot(b.row(row), u);
}

/// Part of a step by which times of masters may be wrong: they are rounded, for instance to nanoseconds, or sums of
/// many steps. It is far below a step that is skipped or repeated.
constexpr double rounded_times = 1e-3;

}  // namespace

Simulation::Simulation(LinearModel model) : model_(std::move(model)) { reset(); }

void Simulation::reset() {
  state_ = {};
  state_.states = model_.initial;
  state_.inputs.assign(model_.inputs(), 0.0);
  state_.slopes.assign(model_.inputs(), 0.0);
}

void Simulation::set_experiment(double start_time, double stop_time) {
  check_finite(start_time, "the start time");
  if (!(stop_time >= start_time)) refuse("the stop time must not be before the start time");
  state_.time = start_time;
  state_.stop_time = stop_time;
}

void Simulation::set_time(double time) {
  check_finite(time, "the time");
  state_.time = time;
}

void Simulation::set_states(std::span<const double> states) {
  if (states.size() != model_.states()) refuse("the model has " + std::to_string(model_.states()) + " states");
  if (!all_finite(states)) refuse("a state must be a finite number");
  state_.states.assign(states.begin(), states.end());
}

void Simulation::set(std::span<const ValueReference> references, std::span<const double> values,
                     bool states_may_be_set) {
  SimulationState next = state_;
  for (std::size_t i = 0; i < references.size(); ++i) {
    const Variable target = variable(model_, references[i]);
    check_finite(values[i], name(target));
    if (target.kind == Kind::input) next.inputs[target.index] = values[i];
    else if (target.kind == Kind::state && states_may_be_set) next.states[target.index] = values[i];
    else refuse(name(target) + " cannot be set here");
  }
  state_ = std::move(next);
}

void Simulation::get(std::span<const ValueReference> references, std::span<double> values) const {
  std::vector<double> found;
  for (const ValueReference reference : references) found.push_back(value(variable(model_, reference)));
  std::ranges::copy(found, values.begin());
}

void Simulation::get_derivatives(std::span<double> values) const {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value({Kind::derivative, i});
}

double Simulation::value(Variable variable) const {
  const std::size_t i = variable.index;
  switch (variable.kind) {
    case Kind::input:
      return state_.inputs[i];
    case Kind::output:
      return row_sum(model_.c, state_.states, model_.d, state_.inputs, i);
    case Kind::state:
      return state_.states[i];
    case Kind::derivative:
      return row_sum(model_.a, state_.states, model_.b, state_.inputs, i);
    case Kind::time:
      break;
  }
  return state_.time;
}

void Simulation::set_slopes(std::span<const ValueReference> references, std::span<const int> orders,
                            std::span<const double> values) {
  const auto inputs = indices(model_, references, Kind::input, "only inputs have derivatives that can be set");
  check_orders(orders);
  if (!all_finite(values)) refuse("the derivative of an input must be a finite number");
  if (state_.slopes_are_used) std::ranges::fill(state_.slopes, 0.0);
  state_.slopes_are_used = false;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (orders[i] <= largest_order) state_.slopes[inputs[i]] = values[i];
}

void Simulation::get_output_slopes(std::span<const ValueReference> references, std::span<const int> orders,
                                   std::span<double> values) const {
  const auto outputs = indices(model_, references, Kind::output, "only derivatives of outputs can be read");
  check_orders(orders);
  std::vector<double> derivatives(model_.states());
  get_derivatives(derivatives);
  for (std::size_t i = 0; i < outputs.size(); ++i)
    values[i] = orders[i] <= largest_order ? row_sum(model_.c, derivatives, model_.d, state_.slopes, outputs[i]) : 0;
}

void Simulation::advance(double from, double step) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  if (!std::isfinite(from) || !std::isfinite(step) || !(step > 0))
    refuse("the step of " + shown(step) + " s from " + shown(from) + " s must be finite and its size above 0");
  const double rounding = 4 * epsilon * (std::abs(from) + step);
  const double tolerance = rounded_times * step + rounding;
  if (std::abs(from - state_.time) > tolerance)
    refuse("the step begins at " + shown(from) + " s, but the present time is " + shown(state_.time) + " s");
  if (from + step > state_.stop_time + tolerance)
    refuse("the step goes beyond the stop time of " + shown(state_.stop_time) + " s");

  if (state_.slopes_are_used) std::ranges::fill(state_.slopes, 0.0);
  // Sizes of steps that a master computes as differences of times differ by rounding. They use one matrix, and the
  // difference is carried to the next step.
  const double wanted = step + state_.behind;
  const StepMatrix& matrix = steps_.nearest(model_, wanted > 0 ? wanted : step, rounding);
  SimulationState next = state_;
  for (std::size_t i = 0; i < next.states.size(); ++i)
    next.states[i] = row_sum(matrix.from_states, state_.states, matrix.from_inputs, state_.inputs, i) +
        dot(matrix.from_slopes.row(i), state_.slopes);
  for (std::size_t j = 0; j < next.inputs.size(); ++j) next.inputs[j] += step * state_.slopes[j];
  if (!all_finite(next.states) || !all_finite(next.inputs)) refuse("the states grow beyond all numbers in this step");
  next.time = from + step;
  next.behind = wanted - matrix.step;
  next.slopes_are_used = true;
  state_ = std::move(next);
}

double Simulation::partial_derivative(ValueReference unknown, ValueReference known) const {
  const Variable result = variable(model_, unknown), cause = variable(model_, known);
  const bool is_output = result.kind == Kind::output;
  if (!is_output && result.kind != Kind::derivative)
    refuse(name(result) + ": only outputs and derivatives of states have partial derivatives");
  if (cause.kind == Kind::state) return (is_output ? model_.c : model_.a)(result.index, cause.index);
  if (cause.kind == Kind::input) return (is_output ? model_.d : model_.b)(result.index, cause.index);
  if (cause.kind != Kind::time) refuse(name(cause) + ": partial derivatives are by inputs, states or time");
  return 0;
}

}  // namespace trivet::fmu
