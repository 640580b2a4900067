// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/assembly/layout.h"

namespace trivet::assembly {

/// Contribution of the forces at rest to K when a body turns about its pole: a preload F that a body exerts on an
/// element at the lever a adds ½(aFᵀ + Faᵀ) − (a·F) I to its rotations; its weight at the centre of mass adds the
/// negative of the same formula (pendulum). Zero for bodies without a preloaded element; the tangent matrices of
/// preloaded elements contain only the effect between their ends.
[[nodiscard]] Eigen::MatrixXd geometric_stiffness(const model::System& system, const Layout& layout);

}  // namespace trivet::assembly
