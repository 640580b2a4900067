// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace trivet::numerics {

/// vᵀMv of a square matrix in extended precision, from its nonzero entries: in a system of many bodies most entries
/// are zero.
class QuadraticForm {
 public:
  explicit QuadraticForm(const Eigen::MatrixXd& M);

  [[nodiscard]] long double operator()(const Eigen::Ref<const Eigen::VectorXd>& v) const;
  /// |v|ᵀ|M||v|: the size of the terms that the form is a sum of.
  [[nodiscard]] double terms(const Eigen::Ref<const Eigen::VectorXd>& v) const;

 private:
  struct Entry {
    Eigen::Index row;
    double value, magnitude;  ///< means of M_ij and M_ji, and of their magnitudes
  };
  std::vector<Entry> entries_;       ///< above the diagonal, column by column
  std::vector<std::size_t> end_of_;  ///< end of each column in `entries_`
  Eigen::VectorXd diagonal_;
};

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

/// Normalises each shape to φᵀAφ = ±1 with a positive largest component. Ascending λ: the Rayleigh quotients in
/// extended precision, 0 if they are round-off of K.
[[nodiscard]] GeneralizedModes normed_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                            const Eigen::MatrixXd& shapes, ModeRoute route);

/// The same with given λ.
[[nodiscard]] GeneralizedModes normed_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                            const Eigen::MatrixXd& shapes, ModeRoute route,
                                            const Eigen::VectorXd& lambda);

/// The `count` lowest modes of K φ = λ A φ with K symmetric and A symmetric positive definite, in which most entries
/// are zero: subspace iteration on sparse factors (Bathe and Wilson 1972). Work and memory grow with the number of
/// nonzero entries. That none is missed is proven by the inertia of K − τA with τ above the last one (Sylvester).
/// Empty if A is not definite, an eigenvalue is negative beyond round-off, the matrices are not sparse, or the proof
/// fails; then `generalized_modes` is the way.
[[nodiscard]] std::optional<GeneralizedModes> lowest_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                                           Eigen::Index count);

}  // namespace trivet::numerics
