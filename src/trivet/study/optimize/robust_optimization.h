// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "trivet/study/optimize/design_objective.h"
#include "trivet/study/optimize/optimization.h"

namespace trivet::study {

/// The best design whose margins keep these reserves.
/// @param near  ends of a search with other reserves, as shares: starts are these and few others; empty: as usual
[[nodiscard]] Optimization optimization_with_reserves(
    const project::Project& project, const DesignObjective::Reserves& reserves, const foundation::Progress& progress,
    const std::function<bool()>& enough, const std::vector<Eigen::VectorXd>& near = {}, SharedWork* shared = nullptr);

/// A design within the ranges as the optimum of a search, which found another one.
/// @param shares  of the ranges  @param search  what that search found
[[nodiscard]] Optimization optimum_at(const project::Project& project, const DesignObjective::Reserves& reserves,
                                      const Eigen::VectorXd& shares, const Optimization& search);

/// The best design of which the machines within the tolerances meet the requirements: a wanted share of them, or the
/// worst ones found. Every round searches with the reserves that the last optimum needs, and where they settle
/// the optimum is sampled with numbers that the search has not used. Mathematics: docs/robust.md.
/// @param shared  looks and climbs of the rounds together with other processes; each samples by itself
/// @throws foundation::InvalidInput, NotComputable as `optimization` and `sample`
[[nodiscard]] Optimization robust_optimization(const project::Project& project, const foundation::Progress& progress,
                                               const std::function<bool()>& enough, SharedWork* shared = nullptr);

}  // namespace trivet::study
