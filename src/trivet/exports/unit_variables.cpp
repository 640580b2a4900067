// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/unit_variables.h"

#include <fmt/format.h>

#include <numeric>
#include <set>

#include "trivet/exports/base_unit.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::exports {
namespace {

/// Position of the first variable of each kind.
struct FirstPositions {
  explicit FirstPositions(const LinearSystem& system)
      : outputs(inputs + system.inputs.size()),
        states(outputs + system.outputs.size()),
        derivatives(states + system.states.size()) {}
  std::size_t inputs = 1, outputs, states, derivatives;
};

std::vector<std::size_t> positions(std::size_t first, std::size_t count) {
  std::vector<std::size_t> list(count);
  std::iota(list.begin(), list.end(), first);
  return list;
}

/// Positions of the inputs and states with factors that are not zero.
std::vector<std::size_t> dependencies(const FirstPositions& first, const Eigen::MatrixXd& of_states,
                                      const Eigen::MatrixXd& of_inputs, Eigen::Index row) {
  std::vector<std::size_t> list;
  for (Eigen::Index j = 0; j < of_inputs.cols(); ++j)
    if (of_inputs(row, j) != 0) list.push_back(first.inputs + to_size(j));
  for (Eigen::Index j = 0; j < of_states.cols(); ++j)
    if (of_states(row, j) != 0) list.push_back(first.states + to_size(j));
  return list;
}

UnitVariable variable(const Signal& signal, const std::string& causality) {
  return {.name = signal.name, .unit = signal.unit, .description = signal.description, .causality = causality};
}

UnitVariable derivative(const Signal& state) {
  return {.name = fmt::format("der({})", state.name),
          .unit = per_second(state.unit),
          .description = fmt::format("time derivative of {}", state.name),
          .causality = "local",
          .initial = "calculated"};
}

void check_names(const std::vector<UnitVariable>& variables) {
  std::set<std::string> names;
  for (const UnitVariable& variable : variables)
    if (!names.insert(variable.name).second)
      throw foundation::InvalidInput(fmt::format(
          "linear system: the name {} is needed for time or for the derivative of a state; choose another name",
          foundation::quoted(variable.name)));
}

}  // namespace

std::vector<UnitVariable> unit_variables(const LinearSystem& system) {
  const FirstPositions first(system);
  const Eigen::VectorXd initial = initial_states(system);
  std::vector<UnitVariable> variables = {{.name = "time", .unit = "s", .causality = "independent"}};
  for (const Signal& input : system.inputs) {
    variables.push_back(variable(input, "input"));
    variables.back().start = 0;
  }
  for (std::size_t i = 0; i < system.outputs.size(); ++i) {
    variables.push_back(variable(system.outputs[i], "output"));
    variables.back().initial = "calculated";
    variables.back().dependencies = dependencies(first, system.C, system.D, to_index(i));
  }
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    variables.push_back(variable(system.states[i], "local"));
    variables.back().initial = "exact";
    variables.back().start = initial(to_index(i));
    variables.back().nominal = system.states[i].nominal;
  }
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    variables.push_back(derivative(system.states[i]));
    variables.back().derivative_of = first.states + i;
    variables.back().dependencies = dependencies(first, system.A, system.B, to_index(i));
  }
  check_names(variables);
  return variables;
}

ComputedVariables computed_variables(const LinearSystem& system) {
  const FirstPositions first(system);
  return {.outputs = positions(first.outputs, system.outputs.size()),
          .derivatives = positions(first.derivatives, system.states.size())};
}

}  // namespace trivet::exports
