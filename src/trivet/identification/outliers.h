// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/identification/grouped_regression.h"

namespace trivet::identification {

struct Contradiction {
  Eigen::Index reading = 0;
  double deviation = 0;  ///< measured − predicted by the remaining readings
  double studentised = 0;
  double limit = 0;
};

/// Readings that contradict the others, worst first: the reading with the largest externally studentised residual is
/// removed while it exceeds Student's limit at risk/(readings), and the rest is fitted again. Stops at a tenth of the
/// readings.
[[nodiscard]] std::vector<Contradiction> contradictions(Regression regression, double risk);

}  // namespace trivet::identification
