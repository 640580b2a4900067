// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/result_figures.h"

#include <algorithm>
#include <cmath>

namespace trivet::report {

double highest_finite(const Eigen::VectorXd& values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

}  // namespace trivet::report
