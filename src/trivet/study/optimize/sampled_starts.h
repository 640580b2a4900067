// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/study/optimize/design_objective.h"

namespace trivet::study {

/// Designs that a search may start from, as shares of the ranges.
struct SampledStarts {
  std::vector<Eigen::VectorXd> points;
  std::size_t judged = 0;  ///< designs among which they are the best; 0 without families
};

/// Designs judged by the kernels of families before a search: points of Sobol's sequence.
inline constexpr std::size_t sampled_designs = 100000;

/// The best of `among` designs that lie apart, judged by the requirements that families cover; without families the
/// first points of Sobol's sequence. The same for any number of threads.
[[nodiscard]] SampledStarts sampled_starts(const DesignObjective& objective, std::size_t wanted,
                                           const foundation::Progress& progress, std::size_t among = sampled_designs);

/// Ranks of designs, one row of shares each, by the requirements that families cover.
/// @param needed  of each design, or empty: one that cannot reach it is judged no further, and has an upper bound
[[nodiscard]] std::vector<double> family_ranks(const DesignObjective& objective, const Eigen::MatrixXd& shares,
                                               const std::vector<double>& needed, const foundation::Progress& progress);

/// Points of Sobol's sequence in the unit cube, one per row.
[[nodiscard]] Eigen::MatrixXd sobol_points(Eigen::Index dimensions, std::size_t count);

/// Violated constraints first count, then the objective.
[[nodiscard]] double rank(double objective, double constraint);

}  // namespace trivet::study
