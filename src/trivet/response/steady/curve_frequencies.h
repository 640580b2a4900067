// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/band.h"

namespace trivet::response {

// Frequencies at which a curve model is solved.

/// Three frequencies for each pole of the band and, if `spread_too`, a few over all of it. @param poles  λ
[[nodiscard]] std::vector<double> first_frequencies(const Eigen::VectorXcd& poles, const assembly::Band& band,
                                                    bool spread_too);

/// Many frequencies, distinct, from which nodes are chosen: three for each pole of the band, and
/// `spread` over all of it.
[[nodiscard]] std::vector<double> candidate_frequencies(const Eigen::VectorXcd& poles, const assembly::Band& band,
                                                        int spread);

}  // namespace trivet::response
