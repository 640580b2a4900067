// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/polynomial_roots.h"

#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::numerics {

std::vector<std::complex<double>> polynomial_roots(const std::vector<double>& coefficients) {
  assert((coefficients.empty() || coefficients.back() != 0) && "the last coefficient gives the degree");
  const auto degree = to_index(coefficients.size()) - 1;
  if (degree < 1) return {};
  // In units of the roots' geometric mean, so that the coefficients are comparable; with roots at 0 the unit is 1.
  const double first = std::abs(coefficients.front()), last = coefficients.back();
  const double unit = first > 0 ? std::pow(first / std::abs(last), 1 / static_cast<double>(degree)) : 1;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  companion.diagonal(-1).setOnes();
  for (Eigen::Index i = 0; i < degree; ++i)
    companion(i, degree - 1) = -coefficients[i] / last * std::pow(unit, static_cast<double>(i - degree));
  const GeneralEigen eigen = general_eigenvalues(companion);
  if (!eigen.converged) throw foundation::NotComputable("the roots of a polynomial did not converge");
  const Eigen::VectorXcd roots = unit * eigen.values;
  return {roots.begin(), roots.end()};
}

}  // namespace trivet::numerics
