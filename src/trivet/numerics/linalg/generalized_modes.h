// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// How K φ = λ A φ was solved.
enum class ModeRoute {
  definite_mass,       ///< A positive definite: Cholesky, all λ real
  definite_stiffness,  ///< A indefinite, K positive definite: solved as A φ = (1/λ) K φ, all λ real
  general              ///< neither, or unsymmetric: general eigensolver, complex λ are counted but excluded
};

/// Solutions of K φ = λ A φ, λ ascending, φᵀAφ = `norm` = +1 or −1. λ within round-off of K are exactly 0.
struct GeneralizedModes {
  ModeRoute route = ModeRoute::definite_mass;
  Eigen::VectorXd lambda;
  Eigen::MatrixXd shapes;
  Eigen::VectorXd norm;
  int complex_pairs = 0;  ///< modes without a real λ (general route only)
};

/// Modes of K φ = λ A φ. Definiteness is always checked first: a generalized solver may return wrong values for an
/// indefinite A. λ counts as 0 if |φᵀKφ| ≤ 1536 ε |φ|ᵀ|K||φ|, or |λ| ≤ (64 n ε)² of the largest.
[[nodiscard]] GeneralizedModes generalized_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, bool symmetric);

}  // namespace trivet::numerics
