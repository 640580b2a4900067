// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/nonnegative_least_squares.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <vector>

namespace trivet::numerics {
namespace {

/// Unconstrained least squares over the columns of the free set, zero elsewhere.
Eigen::VectorXd solution_over(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                              const std::vector<Eigen::Index>& free) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  const Eigen::MatrixXd columns = a(Eigen::all, free);
  x(free) = columns.householderQr().solve(b);
  return x;
}

/// Moves from the feasible x towards `wanted` until the first free component reaches zero, and binds all that are zero
/// there.
void step_to_boundary(Eigen::VectorXd& x, const Eigen::VectorXd& wanted, std::vector<Eigen::Index>& free) {
  double step = 1;
  Eigen::Index first = free.front();
  for (const Eigen::Index j : free)
    if (wanted(j) <= 0 && x(j) <= step * (x(j) - wanted(j))) step = x(j) > 0 ? x(j) / (x(j) - wanted(j)) : 0, first = j;
  assert(step >= 0 && step <= 1 && "between the feasible x and the wanted one");
  x += step * (wanted - x);
  x(first) = 0;
  std::erase_if(free, [&](Eigen::Index j) { return x(j) <= 0 && (x(j) = 0, true); });
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double enough) {
  constexpr double negligible = 1e-13;  // of a column's largest possible gradient
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  const Eigen::VectorXd gradient_scale = b.norm() * a.colwise().norm().transpose();
  std::vector<Eigen::Index> free;
  for (Eigen::Index round = 0; round < 3 * a.cols(); ++round) {
    const Eigen::VectorXd left = b - a * x;
    if (left.norm() <= enough) break;
    const Eigen::VectorXd gradient = a.transpose() * left;
    Eigen::Index entering = -1;
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      if (gradient(j) > negligible * gradient_scale(j) && (entering < 0 || gradient(j) > gradient(entering)))
        if (std::ranges::find(free, j) == free.end()) entering = j;
    if (entering < 0) break;
    free.push_back(entering);
    Eigen::VectorXd wanted = solution_over(a, b, free);
    if (wanted(entering) <= 0) break;  // only round-off remains
    while (!free.empty() && wanted(free).minCoeff() <= 0) {
      step_to_boundary(x, wanted, free);
      if (!free.empty()) wanted = solution_over(a, b, free);
    }
    x = free.empty() ? Eigen::VectorXd::Zero(a.cols()) : wanted;
  }
  assert((x.array() >= 0).all() && "every step ends at the boundary at the latest");
  return x;
}

}  // namespace trivet::numerics
