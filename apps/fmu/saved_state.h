// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "fmu/phase.h"
#include "fmu/simulation.h"

namespace trivet::fmu {

/// The state of an instance to which it can return.
struct SavedState {
  InterfaceKind kind = InterfaceKind::co_simulation;
  Phases phase = phase::instantiated;
  SimulationState simulation;
};

/// The state as bytes, for processors with the same order of bytes. The token of the model is part of them.
[[nodiscard]] std::string serialized(const SavedState& state, const LinearModel& model);

/// @throws std::runtime_error if the bytes are not a state of an instance of this kind and this model
[[nodiscard]] SavedState deserialized(std::string_view bytes, const LinearModel& model, InterfaceKind kind);

}  // namespace trivet::fmu
