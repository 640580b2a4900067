// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/study/optimize/design_objective.h"

namespace trivet::study {

/// True if a population can be judged: families cover every case, and the objective is a least margin.
[[nodiscard]] bool can_evolve(const DesignObjective& objective);

/// The best designs of a population that evolved through the families of designs, some ten thousand designs without
/// their models: differential evolution towards the best ones (Zhang, J.; Sanderson, A. C.: JADE: adaptive differential
/// evolution with optional external archive. IEEE Trans. Evol. Comput. 13 (2009) 945–958; without the archive). It
/// finds designs between local optima that climbs from single points miss. The same for any number of threads.
/// @param first  the population before, as shares; more than 4 designs
/// @returns at most `wanted`, the best first, that lie apart
[[nodiscard]] std::vector<Eigen::VectorXd> evolved_designs(const DesignObjective& objective,
                                                           const std::vector<Eigen::VectorXd>& first,
                                                           std::size_t wanted, const foundation::Progress& progress);

}  // namespace trivet::study
