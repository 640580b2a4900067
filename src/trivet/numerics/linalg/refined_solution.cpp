// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/refined_solution.h"

#include <algorithm>
#include <limits>

namespace trivet::numerics {
namespace {

/// Z itself as a system without mass and damping.
DynamicMatrices stiffness_alone(const ExtendedMatrix& z) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(z.rows(), z.cols());
  return {none, none, z.real().cast<double>(), z.imag().cast<double>(), false};
}

}  // namespace

RefinedSolver::RefinedSolver(ExtendedMatrix Z)
    : z_(std::move(Z)), system_(stiffness_alone(z_)), factors_(system_.factors(0)) {}

ExtendedVector RefinedSolver::solve(const ExtendedVector& b) const {
  using Terms = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const ExtendedProducts products{
      [&](const ExtendedVector& x) -> ExtendedVector { return b - z_ * x; },
      [&](const ExtendedVector& x) -> Terms { return z_.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs(); }};
  if (const auto x = refined_solution(factors_, b, products)) return *x;
  // Too ill-conditioned for factors in double: solve in extended precision.
  return lu_solution(z_, b);
}

double RefinedSolver::condition() const {
  // With a pivot of exactly 0 the estimate would describe only the other coordinates.
  if (factors_.singular()) return std::numeric_limits<double>::infinity();
  constexpr int most_steps = 5;
  const SystemFactors transposed = system_.factors(0, true);
  const Eigen::Index n = z_.rows();
  Eigen::VectorXcd x = Eigen::VectorXcd::Constant(n, 1.0 / static_cast<double>(n));
  double largest = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXcd y = factors_.solve(x);
    if (!y.allFinite()) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, y.lpNorm<1>());
    const Eigen::VectorXcd sign =
        y.unaryExpr([](const Complex& v) { return std::abs(v) > 0 ? v / std::abs(v) : Complex(1); });
    const Eigen::VectorXcd rise = transposed.solve(Eigen::VectorXcd(sign.conjugate())).conjugate();
    Eigen::Index steepest = 0;
    if (!(rise.cwiseAbs().maxCoeff(&steepest) > std::real(rise.dot(x)))) break;
    x = Eigen::VectorXcd::Unit(n, steepest);
  }
  return largest * static_cast<double>(z_.cwiseAbs().colwise().sum().maxCoeff());
}

}  // namespace trivet::numerics
