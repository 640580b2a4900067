// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "trivet/model/excitation.h"

namespace trivet::model {

/// True if it runs with a machine, at multiples of its speed: orders, or, at order 1, an unbalance or a harmonic force
/// on a body. A harmonic motion of the ground comes from elsewhere; it runs with the machine only if it is selected.
[[nodiscard]] inline bool runs_with_machine(const Excitation& excitation) {
  return std::holds_alternative<Orders>(excitation.course) ||
      (std::holds_alternative<Harmonic>(excitation.course) && excitation.action.body);
}

}  // namespace trivet::model
