// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/generalized_modes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::numerics {

QuadraticForm::QuadraticForm(const Eigen::MatrixXd& M) : diagonal_(M.diagonal()) {
  assert(M.rows() == M.cols());
  end_of_.reserve(to_size(M.cols()));
  for (Eigen::Index j = 0; j < M.cols(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i)
      if (M(i, j) != 0 || M(j, i) != 0)
        entries_.push_back({i, 0.5 * (M(i, j) + M(j, i)), 0.5 * (std::abs(M(i, j)) + std::abs(M(j, i)))});
    end_of_.push_back(entries_.size());
  }
}

long double QuadraticForm::operator()(const Eigen::Ref<const Eigen::VectorXd>& v) const {
  assert(v.size() == diagonal_.size());
  using Extended = long double;
  Extended sum = 0;
  std::size_t e = 0;
  for (Eigen::Index j = 0; j < v.size(); ++j) {
    Extended column = 0.5L * diagonal_(j) * v(j);
    for (; e < end_of_[j]; ++e) column += Extended(entries_[e].value) * v(entries_[e].row);
    sum += 2 * column * v(j);
  }
  return sum;
}

double QuadraticForm::terms(const Eigen::Ref<const Eigen::VectorXd>& v) const {
  assert(v.size() == diagonal_.size());
  double sum = 0;
  std::size_t e = 0;
  for (Eigen::Index j = 0; j < v.size(); ++j) {
    double column = 0.5 * std::abs(diagonal_(j) * v(j));
    for (; e < end_of_[j]; ++e) column += entries_[e].magnitude * std::abs(v(entries_[e].row));
    sum += 2 * column * std::abs(v(j));
  }
  return sum;
}

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

namespace {

using foundation::epsilon;

/// YᵀPY = 1 but for round-off? Triangular factors of P lose some n ε of (|L||Lᵀ|)_ij ≤ √(P_ii P_jj).
[[maybe_unused]] bool are_orthonormal(const Eigen::MatrixXd& Y, const Eigen::MatrixXd& P) {
  const double round_off = 64 * static_cast<double>(P.rows()) * epsilon;
  const Eigen::RowVectorXd sums = P.diagonal().cwiseSqrt().transpose() * Y.cwiseAbs();
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(Y.cols(), Y.cols());
  return ((Y.transpose() * P * Y - one).array().abs() <= round_off * (1 + (sums.transpose() * sums).array())).all();
}

/// Shapes y and values of S y = μ P y with P positive definite.
void solve_definite(const Eigen::MatrixXd& S, const Eigen::MatrixXd& P, Eigen::VectorXd& mu, Eigen::MatrixXd& y) {
  const SymmetricEigen<Eigen::MatrixXd> eigen = symmetric_eigen(S, P);
  if (!eigen.converged) throw foundation::NotComputable("the symmetric eigensolver did not converge");
  mu = eigen.values;
  y = eigen.vectors;
  assert(are_orthonormal(y, P));
}

GeneralizedModes general_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A) {
  assert(A.rows() == A.cols() && A.rows() > 0);
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
    shapes.col(i) = eigen.vectors.col(real[i]).real();
    lambda(i) = values(real[i]).real();
  }
  GeneralizedModes result = normed_modes(K, A, shapes, ModeRoute::general, lambda);
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
    result = normed_modes(k, a, y, ModeRoute::definite_mass);
  } else if (symmetric && is_positive_definite(K)) {
    solve_definite(a, k, mu, y);
    result = normed_modes(k, a, y, ModeRoute::definite_stiffness);
  } else {
    result = general_modes(k, a);
  }
  result.shapes = (d.asDiagonal() * result.shapes).eval();
  return result;
}

}  // namespace trivet::numerics
