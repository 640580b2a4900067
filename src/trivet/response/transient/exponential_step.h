// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::response {

/// ∬u, ∫u, u, u̇, ü of an input at one time.
using InputVector = Eigen::Matrix<double, 5, 1>;
inline constexpr Eigen::Index of_value = 2;  ///< index of u in it
/// G in ẋ = F x + Σ G w: states × 5.
using InputMatrix = Eigen::Matrix<double, Eigen::Dynamic, 5>;

/// dw/dt of an input with u‴ = −κ²u′.
[[nodiscard]] InputVector rate(const InputVector& w, double kappa);

/// Exact steps of ẋ = F x + Σ G w while every input obeys u‴ = −κ²u′: x(t + h) = Φ(h) x(t) + Σ Γ(κ, h) w(t) for h =
/// step/2^level. Φ and Γ come from one scaling and squaring of the whole matrix [F G; 0 S(κ)] in extended precision
/// (its Taylor series on the finest level, where no norm is above 1/2), so that round-off of the squarings stays below
/// that of a double. Scaling and squaring: [Moler, Van Loan, SIAM Review 45 (2003) 3–49, method 3]
class ExponentialStep {
 public:
  /// @param largest_kappa  largest κ of all inputs [rad/s]
  ExponentialStep(const Eigen::MatrixXd& F, double step, double largest_kappa);

  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] std::size_t levels() const { return state_.size(); }
  /// Φ(step/2^level).
  [[nodiscard]] const Eigen::MatrixXd& state(std::size_t level) const { return state_[level]; }
  /// Γ(κ, step/2^level), one per level.
  [[nodiscard]] std::vector<InputMatrix> input(const InputMatrix& G, double kappa) const;

 private:
  using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  Extended F_;
  double step_;
  std::vector<Extended> exact_;         ///< Φ per level
  std::vector<Eigen::MatrixXd> state_;  ///< Φ per level, rounded to double
};

/// Number of terms of a Taylor series: the rest is below 1e-21 if the norm is at most 1/2.
inline constexpr int series_terms = 19;

}  // namespace trivet::response
