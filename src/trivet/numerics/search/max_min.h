// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace trivet::numerics {

/// Largest t with objective values v_i(x) ≥ t and constraint values v_i(x) ≥ 0, for 0 ≤ x ≤ 1. The values are smooth
/// but for exchanges of their order. With several groups of objective values, the largest Σ w_g t_g with v_i ≥ t_g of
/// its group.
struct MaxMinProblem {
  Eigen::Index variables = 0;
  std::vector<bool> is_objective;  ///< per value
  /// Values at x, and where it is not null their slopes (values × variables).
  std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& values, Eigen::MatrixXd* slopes)> evaluate;
  std::vector<std::size_t> group = {};  ///< per value; empty: all objectives are one group
  std::vector<double> weights = {};     ///< per group, > 0

  [[nodiscard]] std::size_t groups() const { return group.empty() ? 1 : weights.size(); }
  [[nodiscard]] std::size_t group_of(std::size_t value) const { return group.empty() ? 0 : group[value]; }
  [[nodiscard]] double weight(std::size_t of_group) const { return group.empty() ? 1 : weights[of_group]; }
};

struct MaxMinPoint {
  Eigen::VectorXd x;
  double objective = 0;   ///< the least objective value, or the weighted sum of those of the groups
  double constraint = 0;  ///< the least constraint value; infinite without constraints
};

[[nodiscard]] MaxMinPoint point_at(const MaxMinProblem& problem, const Eigen::VectorXd& x);
/// The same from values that are known.
[[nodiscard]] MaxMinPoint point_with(const MaxMinProblem& problem, const Eigen::VectorXd& x,
                                     const Eigen::VectorXd& values);

/// The largest t near a start, by sequential quadratic programming (NLopt's SLSQP), started again from its own end
/// until it gains nothing. If the first steps lead to nothing better, shorter ones are tried.
[[nodiscard]] MaxMinPoint max_min(const MaxMinProblem& problem, const Eigen::VectorXd& start);

/// Multipliers λ ≥ 0 of the values with Σλ = 1 over the objectives, w_g over those of a group: the least t grows by λ_i
/// if value i is raised by 1. With none that balances the slopes except against the bounds, the point is no optimum.
struct Multipliers {
  Eigen::VectorXd of_values;
  double residual =
      0;  ///< norm of Σ λ_i ∇v_i without what the bounds hold, over the largest norm of a slope, at least 1e-2
};
/// @param active  within this of the least objective value, or of 0 for a constraint
[[nodiscard]] Multipliers multipliers(const MaxMinProblem& problem, const MaxMinPoint& point, double active);

}  // namespace trivet::numerics
