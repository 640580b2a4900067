// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/generalized_modes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/cholesky.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/general_eigen.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/quadratic_form.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"

namespace trivet::numerics {
namespace {

using foundation::epsilon;

/// Round-off of φᵀKφ relative to |φ|ᵀ|K||φ|: some ε for each entry that is a sum over elements, however many rows.
constexpr double free_within = 1536 * epsilon;

/// Shapes y and values of S y = μ P y with P positive definite.
void solve_definite(const Eigen::MatrixXd& S, const Eigen::MatrixXd& P, Eigen::VectorXd& mu, Eigen::MatrixXd& y) {
  const SymmetricEigen<Eigen::MatrixXd> eigen = symmetric_eigen(S, P);
  if (!eigen.converged) throw foundation::NotComputable("the symmetric eigensolver did not converge");
  mu = eigen.values;
  y = eigen.vectors;
}

/// Normalises each shape to φᵀAφ = ±1 with a positive largest component; λ is the Rayleigh quotient in extended
/// precision.
GeneralizedModes finish(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, const Eigen::MatrixXd& shapes,
                        bool rayleigh, const Eigen::VectorXd& given, ModeRoute route) {
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
    lambda(i) = rayleigh ? static_cast<double>(k / a) : given(i);
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
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index x, Eigen::Index y) { return lambda(x) < lambda(y); });
  result.lambda.resize(count);
  result.norm.resize(count);
  result.shapes.resize(n, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = order[to_size(i)];
    result.lambda(i) = lambda(from);
    result.norm(i) = norm(from);
    result.shapes.col(i) = normed.col(from);
  }
  return result;
}

GeneralizedModes general_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A) {
  const GeneralEigen eigen = general_eigen(lu_solution(A, K));
  if (!eigen.converged) throw foundation::NotComputable("the general eigensolver did not converge");
  const Eigen::VectorXcd& values = eigen.values;
  const double scale = values.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> real;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (std::abs(values(i).imag()) <= std::sqrt(epsilon) * 16 * std::abs(values(i)) ||
        std::abs(values(i)) <= 1e-12 * scale)
      real.push_back(i);
  Eigen::MatrixXd shapes(K.rows(), to_index(real.size()));
  Eigen::VectorXd lambda(shapes.cols());
  for (Eigen::Index i = 0; i < shapes.cols(); ++i) {
    shapes.col(i) = eigen.vectors.col(real[to_size(i)]).real();
    lambda(i) = values(real[to_size(i)]).real();
  }
  GeneralizedModes result = finish(K, A, shapes, false, lambda, ModeRoute::general);
  result.complex_pairs = static_cast<int>(values.size() - shapes.cols()) / 2;
  return result;
}

}  // namespace

GeneralizedModes generalized_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, bool symmetric) {
  assert(K.rows() == A.rows() && K.cols() == A.cols());
  const Eigen::VectorXd d = unit_scale(A);
  const Eigen::MatrixXd k = d.asDiagonal() * K * d.asDiagonal();
  const Eigen::MatrixXd a = d.asDiagonal() * A * d.asDiagonal();
  GeneralizedModes result;
  Eigen::VectorXd mu;
  Eigen::MatrixXd y;
  if (symmetric && is_positive_definite(A)) {
    solve_definite(k, a, mu, y);
    result = finish(k, a, y, true, {}, ModeRoute::definite_mass);
  } else if (symmetric && is_positive_definite(K)) {
    solve_definite(a, k, mu, y);
    result = finish(k, a, y, true, {}, ModeRoute::definite_stiffness);
  } else {
    result = general_modes(k, a);
  }
  result.shapes = (d.asDiagonal() * result.shapes).eval();
  return result;
}

}  // namespace trivet::numerics
