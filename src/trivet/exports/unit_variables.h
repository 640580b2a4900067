// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "trivet/exports/linear_system.h"

namespace trivet::exports {

/// Exponents of the base units of a coherent SI unit. As in the interface for mock-up units, radian is a base unit.
struct BaseUnit {
  int kg = 0, m = 0, s = 0, A = 0, K = 0, mol = 0, cd = 0, rad = 0;
  friend bool operator==(const BaseUnit&, const BaseUnit&) = default;
};

/// Base units of "N m", "m/s²", "kg·m^2/s", "1/s": factors between spaces or dots, each with an exponent, and divisors
/// after a slash. Symbols: kg m s A K mol cd rad N Pa J W V C T H Wb F Ohm S 1. A factor cannot follow a divisor.
/// @throws foundation::InvalidInput if the text is not such a unit
[[nodiscard]] BaseUnit base_unit(const std::string& unit);

/// The unit of a derivative with respect to time: "m" → "m/s", "m/s" → "m/s2", "" → "1/s".
[[nodiscard]] std::string per_second(const std::string& unit);

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
