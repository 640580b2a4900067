// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/linalg/pair_form.h"
#include "trivet/numerics/recurrence/pair_steps.h"
#include "trivet/response/transient/exponential_step.h"
#include "trivet/response/transient/state_space.h"

namespace trivet::response {

/// Exact steps of all states of a system, group by group: the cost of a pair does not depend on the number of others.
class ExactSteps {
 public:
  /// @param largest_kappa  largest κ of all inputs [rad/s]
  ExactSteps(const StateSpace& space, double step, double largest_kappa);

  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] std::size_t levels() const { return levels_; }
  /// Norm of F, or the largest κ if it is larger [rad/s].
  [[nodiscard]] double fastest() const { return fastest_; }
  /// Γ(κ, step/2^level) of all states, one per level.
  [[nodiscard]] std::vector<InputMatrix> input(const InputMatrix& G, double kappa) const;

  /// One step of step/2^level per column of w: column 0 of the states is given, the next ones are computed.
  /// @param inputs  columns of Γ of this level and their rows of w
  void take(std::size_t level, const std::vector<numerics::StepInput>& inputs,
            const Eigen::Ref<const Eigen::MatrixXd>& w, Eigen::Ref<Eigen::MatrixXd> states) const;
  /// F x.
  void rate(const Eigen::VectorXd& x, Eigen::VectorXd& result) const;

 private:
  [[nodiscard]] Eigen::ArrayXXd pair_matrix(std::size_t level) const;

  const Eigen::MatrixXd& F_;
  const numerics::StateGroups& groups_;
  double step_, fastest_;
  std::size_t levels_ = 0;
  std::vector<ExponentialStep> pairs_, dense_;  ///< one per pair, and one per dense group
  std::vector<Eigen::ArrayXXd> pair_matrices_;  ///< per level: a, b, c, d of all pairs, as in numerics::PairSteps
  Eigen::ArrayXXd pair_rates_;                  ///< the same of F
};

}  // namespace trivet::response
