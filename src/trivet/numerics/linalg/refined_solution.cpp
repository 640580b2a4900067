// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/refined_solution.h"

#include <limits>

namespace trivet::numerics {

RefinedSolver::RefinedSolver(ExtendedMatrix Z) : z_(std::move(Z)), factors_(z_.cast<std::complex<double>>()) {}

ExtendedVector RefinedSolver::solve(const ExtendedVector& b) const {
  constexpr int most_steps = 12;
  constexpr long double settled = 64 * std::numeric_limits<long double>::epsilon();
  const auto step = [&](const ExtendedVector& r) -> ExtendedVector {
    return factors_.solve(Eigen::VectorXcd(r.cast<std::complex<double>>())).cast<std::complex<long double>>();
  };
  ExtendedVector x = step(b);
  long double previous = std::numeric_limits<long double>::infinity();
  for (int i = 0; i < most_steps; ++i) {
    const ExtendedVector correction = step(b - z_ * x);
    const long double size = correction.norm();
    if (size <= settled * x.norm()) return x + correction;
    if (!(size < 0.5L * previous)) break;
    x += correction;
    previous = size;
  }
  // Too ill-conditioned for factors in double: solve in extended precision.
  return lu_solution(z_, b);
}

double RefinedSolver::condition() const {
  // With a pivot of exactly 0 the estimate would describe only the other coordinates.
  if (!(factors_.smallest_pivot() > 0)) return std::numeric_limits<double>::infinity();
  const double reciprocal = factors_.reciprocal_condition();
  return reciprocal > 0 ? 1 / reciprocal : std::numeric_limits<double>::infinity();
}

}  // namespace trivet::numerics
