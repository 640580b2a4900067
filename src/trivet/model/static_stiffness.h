// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"

/// Rubber is softer under a static load than in vibration: `Element::stiffening`. The laws of a system are those of
/// vibration.
namespace trivet::model {

/// Has an element a static stiffness of its own? Never in a machine with nonlinear parts, where one force is that of
/// rest and of vibration.
[[nodiscard]] bool has_static_stiffness(const System& system);

/// The same machine with the static stiffnesses of its elements.
[[nodiscard]] System with_static_stiffness(const System& system);

}  // namespace trivet::model
