// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/pivoted_solution.h"

#include <cassert>
#include <limits>

#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::numerics {

PivotedSolution pivoted_solution(const Eigen::MatrixXcd& Z, const Eigen::VectorXcd& h, bool with_condition) {
  assert(Z.rows() == Z.cols() && h.size() == Z.rows());
  const PivotedLu<std::complex<double>> lu(Z);
  PivotedSolution result{lu.solve(h)};
  Eigen::VectorXcd& x = result.x;
  const Eigen::VectorXcd reached = Z * x;
  x += lu.solve(Eigen::VectorXcd(h - reached));
  const double norm = Z.cwiseAbs().rowwise().sum().maxCoeff();
  if (!x.allFinite() || lu.smallest_pivot() <= negligible_pivot(static_cast<int>(Z.rows())) * norm) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    x.setConstant({nan, nan});
    return {x, nan, std::numeric_limits<double>::infinity()};
  }
  const double possible = norm * x.cwiseAbs().maxCoeff() + h.cwiseAbs().maxCoeff();
  result.backward_error = possible > 0 ? (h - Z * x).cwiseAbs().maxCoeff() / possible : 0;
  if (with_condition) result.condition = 1 / lu.reciprocal_condition();
  return result;
}

}  // namespace trivet::numerics
