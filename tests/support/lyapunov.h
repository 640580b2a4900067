// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::test {

/// Covariance P of the states of x' = state · x + w under white noise of intensity E[w(t) wᵀ(t′)] = intensity · δ(t −
/// t′): the solution of state P + P stateᵀ + intensity = 0, by the Schur form of `state`. [Bartels and Stewart,
/// Communications of the ACM 15 (1972) 820–826] A one-sided spectral density S over ω [unit²/(rad/s)], the same at all
/// ω, is an intensity π S.
/// @throws foundation::NotComputable unless every eigenvalue of `state` has a negative real part
[[nodiscard]] Eigen::MatrixXd lyapunov_covariance(const Eigen::MatrixXd& state, const Eigen::MatrixXd& intensity);

}  // namespace trivet::test
