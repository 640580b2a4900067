// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/student_distribution.h"

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <unsupported/Eigen/SpecialFunctions>

#include "trivet/foundation/invalid_input.h"

namespace trivet::identification {
namespace {

/// Probability outside (−t, t): the regularised incomplete beta function I_x(ν/2, 1/2) at x = ν/(ν + t²).
double outside(double t, double degrees_of_freedom) {
  using One = Eigen::Array<double, 1, 1>;
  const One a(0.5 * degrees_of_freedom), b(0.5), x(degrees_of_freedom / (degrees_of_freedom + t * t));
  const One tail = Eigen::betainc(a, b, x);
  return tail(0);
}

}  // namespace

double student_quantile(double confidence, double degrees_of_freedom) {
  if (!(confidence > 0 && confidence < 1))
    throw foundation::InvalidInput("confidence " + std::to_string(confidence) + ", must be between 0 and 1");
  if (!(degrees_of_freedom > 0))
    throw foundation::InvalidInput("degrees of freedom " + std::to_string(degrees_of_freedom) + ", must be > 0");
  constexpr double practically_normal = 1e6;  // beyond it the quantile changes by less than 1e-6 of itself
  const double freedom = std::min(degrees_of_freedom, practically_normal);
  double low = 0, high = 1;
  while (outside(high, freedom) > 1 - confidence) high *= 2;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (outside(middle, freedom) > 1 - confidence ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace trivet::identification
