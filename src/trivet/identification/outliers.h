// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/identification/grouped_regression.h"

namespace trivet::identification {

struct Contradiction {
  Eigen::Index reading = 0;
  double deviation = 0;  ///< measured − foretold by the readings that are left
  double studentised = 0;
  double limit = 0;
};

/// Readings that the others contradict, the worst first: the reading with the largest externally studentised residual
/// is set aside while it exceeds Student's limit at risk/(readings), and the rest is fitted anew. Stops at a tenth of
/// the readings.
[[nodiscard]] std::vector<Contradiction> contradictions(Regression regression, double risk);

}  // namespace trivet::identification
