// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/search/max_min.h"
#include "trivet/study/optimize/design_objective.h"

/// The searches of which a front consists. Amplitudes are in units of their limits, or SI without limits.
namespace trivet::study {

/// The largest amplitude of each objective, and the least ln(margin) of the requirements, at a design.
struct FrontValues {
  Eigen::VectorXd x;
  Eigen::VectorXd amplitudes;  ///< infinite for designs without a model
  double constraint = 0;
};
[[nodiscard]] FrontValues front_values(const DesignObjective& objective, const Eigen::VectorXd& x);

/// The smallest amplitude of one objective.
[[nodiscard]] numerics::MaxMinProblem least_amplitude(const DesignObjective& objective, std::size_t wanted);

/// The smallest amplitude of one objective while others stay below these.
/// @param held  per objective; infinite: free
[[nodiscard]] numerics::MaxMinProblem least_amplitude_below(const DesignObjective& objective, std::size_t wanted,
                                                            const Eigen::VectorXd& held);

/// The largest t with amplitude_i ≤ from_i − t · width_i for all objectives: from a point straight towards less of all.
[[nodiscard]] numerics::MaxMinProblem towards_less(const DesignObjective& objective, const Eigen::VectorXd& from,
                                                   const Eigen::VectorXd& width);

}  // namespace trivet::study
