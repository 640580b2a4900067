// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/state_basis.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"

namespace trivet::response {
namespace {

using foundation::epsilon;

std::vector<Eigen::Index> massless_rows(const numerics::DynamicMatrices& m, const std::vector<Eigen::Index>& massive) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < m.size(); ++i)
    if (!std::ranges::binary_search(massive, i)) rows.push_back(i);
  return rows;
}

/// Transforms the massless coordinates so that dashpots act on the first of them only.
void part_massless(const numerics::DynamicMatrices& m, const std::vector<Eigen::Index>& rows, Eigen::MatrixXd& R,
                   StateBasis& basis) {
  const Eigen::MatrixXd held = R.transpose() * m.B * R;
  const auto count = to_index(rows.size());
  basis.lagging = count;
  if (!held.isApprox(held.transpose(), 1e-12) && !held.isZero(0)) return;  // unsymmetric: must be regular
  const numerics::SymmetricEigen<Eigen::MatrixXd> eigen = numerics::symmetric_eigen(held);
  const double none = 64 * static_cast<double>(count) * epsilon * eigen.values.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> lagging, following;
  for (Eigen::Index i = 0; i < count; ++i) (std::abs(eigen.values(i)) > none ? lagging : following).push_back(i);
  if (following.empty()) return;
  basis.lagging = to_index(lagging.size());
  basis.following = to_index(following.size());
  lagging.insert(lagging.end(), following.begin(), following.end());
  R = (R * eigen.vectors(Eigen::all, lagging)).eval();
}

/// Uses the modes of the massive coordinates, if there are as many real ones as coordinates.
bool set_modal_basis(const numerics::DynamicMatrices& m, Eigen::MatrixXd& P, StateBasis& basis) {
  if (!m.symmetric) return false;
  const numerics::MassiveSystem massive = numerics::massive_system(m);
  const numerics::GeneralizedModes modes = numerics::generalized_modes(massive.K, massive.A, true);
  if (modes.lambda.size() != basis.massive) return false;
  P = massive.recovery * modes.shapes;
  basis.A = modes.norm.asDiagonal();
  basis.K = (modes.norm.array() * modes.lambda.array()).matrix().asDiagonal();
  double slowest = 0;
  for (const double lambda : modes.lambda)
    if (lambda != 0 && (slowest == 0 || std::abs(lambda) < slowest)) slowest = std::abs(lambda);
  basis.speed = modes.lambda.unaryExpr([&](double lambda) {
    return lambda != 0 ? std::sqrt(std::abs(lambda)) : slowest > 0 ? std::sqrt(slowest) : 1.0;
  });
  return true;
}

void require_quiet(const Eigen::MatrixXd& B, Eigen::Index first) {
  constexpr double round_off = 1e-10;
  const double scale = B.cwiseAbs().maxCoeff();
  if (B.bottomRows(B.rows() - first).cwiseAbs().maxCoeff() > round_off * scale ||
      B.rightCols(B.cols() - first).cwiseAbs().maxCoeff() > round_off * scale)
    throw foundation::NotComputable(
        "a coordinate without mass and without damping of its own is coupled to others by damping: its time history is "
        "not determined; give it a mass or a dashpot");
}

}  // namespace

StateBasis state_basis(const numerics::DynamicMatrices& m) {
  StateBasis basis;
  const std::vector<Eigen::Index> massive = numerics::massive_rows(m.A), massless = massless_rows(m, massive);
  const Eigen::VectorXd scale = numerics::unit_scale(m);
  const Eigen::Index n = m.size(), count = to_index(massive.size());
  basis.massive = count;
  Eigen::MatrixXd P, R = Eigen::MatrixXd::Zero(n, n - count);
  for (std::size_t i = 0; i < massless.size(); ++i) R(massless[i], to_index(i)) = scale(massless[i]);
  if (!massless.empty()) part_massless(m, massless, R, basis);
  assert(basis.massive + basis.lagging + basis.following == n && "mass, dampers or springs alone move each coordinate");
  basis.modal = set_modal_basis(m, P, basis);
  if (!basis.modal) {
    P = Eigen::MatrixXd::Zero(n, count);
    for (std::size_t i = 0; i < massive.size(); ++i) P(massive[i], to_index(i)) = scale(massive[i]);
    basis.A = P.transpose() * m.A * P;
  }
  basis.T.resize(n, n);
  basis.T << P, R;
  const Eigen::MatrixXd modal_stiffness = basis.K;
  basis.B = basis.T.transpose() * m.B * basis.T;
  basis.K = basis.T.transpose() * m.K * basis.T;
  if (basis.following > 0) require_quiet(basis.B, n - basis.following);
  if (basis.modal) {
    basis.K.topRightCorner(count, n - count).setZero();
    basis.K.bottomLeftCorner(n - count, count).setZero();
    basis.K.topLeftCorner(count, count) = modal_stiffness;
  } else {
    basis.speed = Eigen::VectorXd::Constant(
        count, std::sqrt(std::max(basis.K.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min())));
  }
  const numerics::PivotedLu<double> inertia(basis.A);
  if (count > 0 && inertia.reciprocal_condition() < epsilon)
    throw foundation::NotComputable(
        "the mass matrix of the moving coordinates is singular: some motion has no inertia");
  basis.from_coordinates.resize(n, n);
  basis.from_coordinates.topRows(count) = inertia.solve(Eigen::MatrixXd(P.transpose() * m.A));
  if (!massless.empty()) {
    const Eigen::MatrixXd own = R(massless, Eigen::all), ridden = P(massless, Eigen::all);
    Eigen::MatrixXd rest = -ridden * basis.from_coordinates.topRows(count);
    for (std::size_t i = 0; i < massless.size(); ++i) rest(to_index(i), massless[i]) += 1;
    basis.from_coordinates.bottomRows(n - count) = numerics::lu_solution(own, rest);
  }
  return basis;
}

}  // namespace trivet::response
