// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "trivet/numerics/linalg/generalized_modes.h"

namespace trivet::numerics {

/// The `count` lowest modes of K φ = λ A φ with K symmetric and A symmetric positive definite, in which most entries
/// are zero: subspace iteration on sparse factors (Bathe and Wilson 1972). Work and memory grow with the number of
/// nonzero entries. That none is missed is proven by the inertia of K − τA with τ above the last one (Sylvester).
/// Empty if A is not definite, an eigenvalue is negative beyond round-off, the matrices are not sparse, or the proof
/// fails; then `generalized_modes` is the way.
[[nodiscard]] std::optional<GeneralizedModes> lowest_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                                           Eigen::Index count);

}  // namespace trivet::numerics
