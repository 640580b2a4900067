// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "fmu/linear_model.h"

/// Value references of a model with m inputs, p outputs and n states, each range in the order of the description:
///     0                                     time
///     1 … m                                 inputs
///     m + 1 … m + p                         outputs
///     m + p + 1 … m + p + n                 states
///     m + p + n + 1 … m + p + 2 n           derivatives of the states
namespace trivet::fmu {

using ValueReference = std::uint32_t;

/// A variable: its kind, and its index in the range of this kind.
struct Variable {
  enum class Kind { time, input, output, state, derivative };
  Kind kind = Kind::time;
  std::size_t index = 0;
};

/// @throws std::runtime_error if the model has no variable of this reference
[[nodiscard]] Variable variable(const LinearModel& model, ValueReference reference);

[[nodiscard]] ValueReference reference(const LinearModel& model, Variable variable);

/// "state 3": the kind and the position, counted from 1.
[[nodiscard]] std::string name(Variable variable);

}  // namespace trivet::fmu
