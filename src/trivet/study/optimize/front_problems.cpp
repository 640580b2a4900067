// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/front_problems.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"

namespace trivet::study {
namespace {

/// Where an objective cannot be computed: worse than every amplitude, and small enough for the search.
constexpr double far_below = -1e3;

/// The problem of all objectives, whose values another one rewrites.
numerics::MaxMinProblem rewritten(
    const DesignObjective& objective,
    const std::function<void(std::size_t wanted, double& value, Eigen::MatrixXd* slopes, Eigen::Index row)>& rewrite) {
  return {to_index(objective.space().size()), objective.is_objective(),
          [&objective, rewrite](const Eigen::VectorXd& x, Eigen::VectorXd& values, Eigen::MatrixXd* slopes) {
            objective.evaluate(x, values, slopes);
            for (std::size_t i = 0; i < objective.places().size(); ++i)
              if (objective.is_objective()[i])
                rewrite(objective.minimized().number(objective.places()[i]), values(to_index(i)), slopes, to_index(i));
          }};
}

void ignore(double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
  value = DesignObjective::most;
  if (slopes) slopes->row(row).setZero();
}

}  // namespace

FrontValues front_values(const DesignObjective& objective, const Eigen::VectorXd& x) {
  FrontValues result{x, Eigen::VectorXd::Zero(to_index(objective.minimized().count())), foundation::infinity};
  Eigen::VectorXd values;
  objective.evaluate(x, values, nullptr);
  for (std::size_t i = 0; i < objective.places().size(); ++i) {
    const double value = values(to_index(i));
    if (!objective.is_objective()[i]) {
      result.constraint = std::min(result.constraint, value);
      continue;
    }
    double& largest = result.amplitudes(to_index(objective.minimized().number(objective.places()[i])));
    largest = std::max(largest, value <= DesignObjective::unusable ? foundation::infinity : std::exp(-value));
  }
  return result;
}

numerics::MaxMinProblem least_amplitude(const DesignObjective& objective, std::size_t wanted) {
  return rewritten(objective, [wanted](std::size_t number, double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
    if (number != wanted) ignore(value, slopes, row);
  });
}

numerics::MaxMinProblem least_amplitude_below(const DesignObjective& objective, std::size_t wanted,
                                              const Eigen::VectorXd& held) {
  numerics::MaxMinProblem problem = rewritten(
      objective, [wanted, held](std::size_t number, double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
        if (number == wanted) return;
        if (std::isfinite(held(to_index(number)))) value += std::log(held(to_index(number)));
        else ignore(value, slopes, row);
      });
  for (std::size_t i = 0; i < objective.places().size(); ++i)
    problem.is_objective[i] =
        objective.is_objective()[i] && objective.minimized().number(objective.places()[i]) == wanted;
  return problem;
}

numerics::MaxMinProblem towards_less(const DesignObjective& objective, const Eigen::VectorXd& from,
                                     const Eigen::VectorXd& width) {
  return rewritten(objective,
                   [from, width](std::size_t number, double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
                     const Eigen::Index k = to_index(number);
                     if (value <= DesignObjective::unusable) {
                       value = far_below;
                       return;
                     }
                     const double amplitude = std::exp(-value);
                     value = std::max((from(k) - amplitude) / width(k), far_below);
                     if (slopes) slopes->row(row) *= amplitude / width(k);
                   });
}

}  // namespace trivet::study
