// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/matrix_exponential.h"

#include <cassert>
#include <cmath>

#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::numerics {

using Eigen::MatrixXd;

MatrixXd matrix_exponential(const MatrixXd& A) {
  constexpr double largest = 0.95;  // of the 1-norm, for which the approximant is exact to round-off
  if (A.size() == 0) return A;
  assert(A.rows() == A.cols());
  const double norm = A.cwiseAbs().colwise().sum().maxCoeff();
  if (!std::isfinite(norm)) return MatrixXd::Constant(A.rows(), A.cols(), norm);
  const int squarings = norm > largest ? static_cast<int>(std::ceil(std::log2(norm / largest))) : 0;
  const MatrixXd a = A * std::ldexp(1.0, -squarings), one = MatrixXd::Identity(A.rows(), A.cols());
  // Halving is exact unless the smallest numbers underflow.
  assert(squarings >= 0 && a.cwiseAbs().colwise().sum().maxCoeff() <= largest * (1 + 1e-12));
  const MatrixXd second = a * a, fourth = second * second, sixth = fourth * second;
  const MatrixXd odd = a * (sixth + 1512 * fourth + 277200 * second + 8648640 * one),
                 even = 56 * sixth + 25200 * fourth + 1995840 * second + 17297280 * one;
  MatrixXd result = PivotedLu<double>(even - odd).solve(MatrixXd(even + odd));
  for (int i = 0; i < squarings; ++i) result = (result * result).eval();
  return result;
}

}  // namespace trivet::numerics
