// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "trivet/exports/linear_system.h"

namespace trivet::exports {

/// A variable of a mock-up unit.
struct UnitVariable {
  std::string name, unit, description;
  std::string causality;
  std::string initial;                                   ///< empty if the interface allows none
  std::optional<double> start, nominal;                  ///< in this unit
  std::optional<std::size_t> derivative_of;              ///< position of the state
  std::optional<std::vector<std::size_t>> dependencies;  ///< positions of states and inputs, for computed variables
};

/// All variables; their position is their value reference: time, inputs, outputs, states, derivatives of the states.
/// The shared library in apps/fmu has the same order.
/// @throws foundation::InvalidInput if "time" or "der(x)" for a state x is the name of a signal
[[nodiscard]] std::vector<UnitVariable> unit_variables(const LinearSystem& system);

/// Positions of the outputs, and of the derivatives of the states.
struct ComputedVariables {
  std::vector<std::size_t> outputs, derivatives;
};
[[nodiscard]] ComputedVariables computed_variables(const LinearSystem& system);

}  // namespace trivet::exports
