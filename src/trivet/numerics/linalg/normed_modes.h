// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/generalized_modes.h"

namespace trivet::numerics {

/// Normalises each shape to φᵀAφ = ±1 with a positive largest component. Ascending λ: the Rayleigh quotients in
/// extended precision, 0 if they are round-off of K.
[[nodiscard]] GeneralizedModes normed_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                            const Eigen::MatrixXd& shapes, ModeRoute route);

/// The same with given λ.
[[nodiscard]] GeneralizedModes normed_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                            const Eigen::MatrixXd& shapes, ModeRoute route,
                                            const Eigen::VectorXd& lambda);

}  // namespace trivet::numerics
