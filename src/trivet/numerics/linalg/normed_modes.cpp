// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/normed_modes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/quadratic_form.h"

namespace trivet::numerics {
namespace {

using foundation::epsilon;

/// Round-off of φᵀKφ relative to |φ|ᵀ|K||φ|: some ε for each entry that is a sum over elements, however many rows.
constexpr double free_within = 1536 * epsilon;

/// @param given  λ; null: the Rayleigh quotients
GeneralizedModes normed(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, const Eigen::MatrixXd& shapes,
                        ModeRoute route, const Eigen::VectorXd* given) {
  assert(shapes.rows() == K.rows() && (!given || given->size() == shapes.cols()));
  const Eigen::Index n = K.rows(), count = shapes.cols();
  GeneralizedModes result;
  result.route = route;
  Eigen::VectorXd lambda(count), norm(count);
  Eigen::MatrixXd normed = shapes;
  const Eigen::VectorXd weight = A.diagonal().cwiseAbs().cwiseSqrt();
  const QuadraticForm mass(A), stiffness(K);
  for (Eigen::Index i = 0; i < count; ++i) {
    const long double a = mass(shapes.col(i));
    const long double k = stiffness(shapes.col(i));
    lambda(i) = given ? (*given)(i) : static_cast<double>(k / a);
    const double available = stiffness.terms(shapes.col(i));
    if (std::abs(static_cast<double>(k)) <= free_within * available) lambda(i) = 0;
    norm(i) = a < 0 ? -1 : 1;
    normed.col(i) /= std::sqrt(std::abs(static_cast<double>(a)));
    Eigen::Index largest = 0;
    weight.cwiseProduct(normed.col(i).cwiseAbs()).maxCoeff(&largest);
    if (normed(largest, i) < 0) normed.col(i) *= -1;
  }
  // A shape that moves only where K is zero gives a λ of squared round-off, ε² of the largest λ.
  const double negligible =
      std::pow(64 * static_cast<double>(n) * epsilon, 2) * (count > 0 ? lambda.cwiseAbs().maxCoeff() : 0);
  lambda = (lambda.array().abs() <= negligible).select(0.0, lambda);
  std::vector<Eigen::Index> order(to_size(count));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, [&](Eigen::Index x, Eigen::Index y) { return lambda(x) < lambda(y); });
  assert(to_index(order.size()) == count && lambda.size() == count);
  result.lambda.resize(count);
  result.norm.resize(count);
  result.shapes.resize(n, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = order[i];
    result.lambda(i) = lambda(from);
    result.norm(i) = norm(from);
    result.shapes.col(i) = normed.col(from);
  }
  return result;
}

}  // namespace

GeneralizedModes normed_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, const Eigen::MatrixXd& shapes,
                              ModeRoute route) {
  return normed(K, A, shapes, route, nullptr);
}

GeneralizedModes normed_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, const Eigen::MatrixXd& shapes,
                              ModeRoute route, const Eigen::VectorXd& lambda) {
  return normed(K, A, shapes, route, &lambda);
}

}  // namespace trivet::numerics
