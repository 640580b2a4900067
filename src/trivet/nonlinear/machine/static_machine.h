// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"

namespace trivet::nonlinear {

/// A machine in its position of rest, as every static result sees it (response::AtRest): displacements from the
/// undeformed state are those of a linear machine with the same forces at rest. That of tangents, unless they do not
/// hold it: a cubic spring that bears nothing, struts that cancel a spring. Then positive references of the parts that
/// have a force beside rest take their place.
struct StaticMachine {
  model::System system;
  assembly::Assembled assembled;
};
/// @param system     at rest
/// @param assembled  of its tangents
[[nodiscard]] StaticMachine static_machine(const model::System& system, const assembly::Assembled& assembled);

}  // namespace trivet::nonlinear
