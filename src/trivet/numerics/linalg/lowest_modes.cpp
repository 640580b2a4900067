// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/generalized_modes.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::numerics {
namespace {

using SparseReal = Eigen::SparseMatrix<double>;

constexpr double most_iterated = 0.1;  ///< share of nonzero entries; with more, dense eigensolvers are as fast

/// d_i M_ij d_j of the nonzero entries.
SparseReal sparse_of(const Eigen::MatrixXd& M, const Eigen::VectorXd& d) {
  std::vector<Eigen::Triplet<double, Eigen::Index>> entries;
  for (Eigen::Index j = 0; j < M.cols(); ++j)
    for (Eigen::Index i = 0; i < M.rows(); ++i)
      if (M(i, j) != 0) entries.emplace_back(i, j, d(i) * M(i, j) * d(j));
  SparseReal result(M.rows(), M.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::MatrixXd random_columns(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> entry(-1, 1);
  Eigen::MatrixXd x(rows, columns);
  for (double& value : x.reshaped()) value = entry(generator);
  return x;
}

/// Subspace iteration with a shift σ below all eigenvalues of K − λA.
class Subspace {
 public:
  Subspace(const SparseReal& k, const SparseReal& a, Eigen::Index size)
      : k_(k), a_(a), x_(random_columns(k.rows(), size)), theta_(Eigen::VectorXd::Ones(size)) {}

  /// False if K − σA is not positive definite.
  bool set_shift(double sigma) {
    sigma_ = sigma;
    factors_.compute(k_ - sigma * a_);
    return factors_.info() == Eigen::Success;
  }

  /// One step; false if the subspace has lost a direction.
  bool step() {
    Eigen::MatrixXd y = factors_.solve(Eigen::MatrixXd(a_ * x_));
    const Eigen::MatrixXd image = k_ * y, momentum = a_ * y;
    const Eigen::VectorXd length = (y.cwiseProduct(momentum)).colwise().sum().cwiseSqrt();
    if (!(length.minCoeff() > 0) || !length.allFinite()) return false;
    const Eigen::VectorXd inverse = length.cwiseInverse();
    const Eigen::MatrixXd small_k = inverse.asDiagonal() * (y.transpose() * image) * inverse.asDiagonal(),
                          small_a = inverse.asDiagonal() * (y.transpose() * momentum) * inverse.asDiagonal();
    const SymmetricEigen<Eigen::MatrixXd> ritz = symmetric_eigen(small_k, small_a);
    if (!ritz.converged || !ritz.vectors.allFinite()) return false;
    theta_ = ritz.values;
    assert(std::ranges::is_sorted(theta_) && "the first columns converge to the lowest modes");
    x_ = y * (inverse.asDiagonal() * ritz.vectors);
    return true;
  }

  /// ‖Kx − θAx‖ / ((|θ| + |σ|) ‖Ax‖) of the first columns, the largest.
  [[nodiscard]] double residual(Eigen::Index columns) const {
    const Eigen::MatrixXd momentum = a_ * x_.leftCols(columns);
    const Eigen::MatrixXd rest = k_ * x_.leftCols(columns) - momentum * theta_.head(columns).asDiagonal();
    const Eigen::ArrayXd size =
        (theta_.head(columns).array().abs() + std::abs(sigma_)) * momentum.colwise().norm().transpose().array();
    return (rest.colwise().norm().transpose().array() / size).maxCoeff();
  }

  [[nodiscard]] const Eigen::MatrixXd& shapes() const { return x_; }
  [[nodiscard]] const Eigen::VectorXd& theta() const { return theta_; }

 private:
  const SparseReal &k_, &a_;
  Eigen::SimplicialLLT<SparseReal> factors_;
  double sigma_ = 0;
  Eigen::MatrixXd x_;  ///< A-orthonormal after a step
  Eigen::VectorXd theta_;
};

/// Number of negative eigenvalues of K − τA; empty if its factors, which have no pivoting, are not accurate enough to
/// tell eigenvalues `gap` away.
std::optional<Eigen::Index> inertia_below(const SparseReal& k, const SparseReal& a, double tau, double gap) {
  const SparseReal shifted = k - tau * a;
  const Eigen::SimplicialLDLT<SparseReal> factors(shifted);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixXd b = random_columns(k.rows(), 3), x = factors.solve(b);
  const Eigen::MatrixXd error = shifted * x - b;
  constexpr double share_of_gap = 0.01;
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    if (!(error.col(j).norm() <= share_of_gap * gap * x.col(j).norm())) return std::nullopt;
  return (factors.vectorD().array() < 0).count();
}

/// Columns, `count` or a few more, before the largest step of the eigenvalues there.
Eigen::Index columns_before_step(const Eigen::VectorXd& theta, Eigen::Index count) {
  assert(count > 0 && count + 2 <= theta.size() && "the subspace has more columns than are wanted");
  constexpr Eigen::Index most_more = 6;
  Eigen::Index best = count;
  for (Eigen::Index c = count; c <= std::min(count + most_more, theta.size() - 2); ++c)
    if (theta(c) - theta(c - 1) > theta(best) - theta(best - 1)) best = c;
  return best;
}

}  // namespace

std::optional<GeneralizedModes> lowest_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, Eigen::Index count) {
  assert(K.rows() == A.rows() && K.cols() == A.cols() && count > 0);
  const Eigen::Index n = K.rows(), size = 2 * count + 8;
  if (size > n / 2) return std::nullopt;
  const Eigen::VectorXd d = unit_scale(A);
  const SparseReal k = sparse_of(K, d), a = sparse_of(A, d);
  if (static_cast<double>(k.nonZeros()) > most_iterated * static_cast<double>(n) * static_cast<double>(n))
    return std::nullopt;
  if (Eigen::SimplicialLLT<SparseReal>(a).info() != Eigen::Success) return std::nullopt;

  // The shift follows the eigenvalues: it lies below the first one by a tenth of the width of the subspace.
  constexpr int most_steps = 200;
  constexpr double settled = 1e-11, below = 0.1, far = 3;
  const double round_off = 16 * foundation::epsilon * k.diagonal().maxCoeff();  // of Kx
  if (!(round_off > 0)) return std::nullopt;
  Subspace subspace(k, a, size);
  double shift = -1e-3 * k.diagonal().mean();
  if (!subspace.set_shift(shift)) return std::nullopt;
  for (int step = 0; step < most_steps; ++step) {
    if (!subspace.step()) return std::nullopt;
    if (step % 4 != 3) continue;
    const double first = subspace.theta()(0),
                 distance = std::max(below * (subspace.theta()(size - 1) - first), 64 * round_off);
    if (distance * far < first - shift) {
      const bool is_below_all = subspace.set_shift(first - distance);
      if (is_below_all) shift = first - distance;
      else if (!subspace.set_shift(shift)) return std::nullopt;
      continue;
    }
    const Eigen::Index columns = columns_before_step(subspace.theta(), count);
    if (subspace.residual(columns + 1) > std::max(settled, round_off / (std::abs(first) + std::abs(shift)))) continue;
    const double lower = subspace.theta()(columns - 1), upper = subspace.theta()(columns);
    const auto found = inertia_below(k, a, (lower + upper) / 2, (upper - lower) / 2);
    if (!found || *found != columns) return std::nullopt;
    GeneralizedModes result = normed_modes(Eigen::MatrixXd(k), Eigen::MatrixXd(a), subspace.shapes().leftCols(count),
                                           ModeRoute::definite_mass);
    result.shapes = (d.asDiagonal() * result.shapes).eval();
    return result;
  }
  return std::nullopt;
}

}  // namespace trivet::numerics
