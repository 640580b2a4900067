// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/state_space.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/numerics/recurrence/pair_steps.h"

namespace trivet::response {

namespace {

LinearRows operator+(const LinearRows& a, const LinearRows& b) {
  return {a.on_state + b.on_state, a.on_input + b.on_input};
}
LinearRows operator-(const LinearRows& a) { return {-a.on_state, -a.on_input}; }
LinearRows operator*(const Eigen::MatrixXd& m, const LinearRows& a) { return {m * a.on_state, m * a.on_input}; }

LinearRows solved(const Eigen::MatrixXd& matrix, const LinearRows& right, const char* otherwise) {
  constexpr double smallest_condition = 1e-14;
  if (matrix.rows() == 0) return right;
  const numerics::PivotedLu<double> lu(matrix);
  if (!(lu.reciprocal_condition() > smallest_condition)) throw foundation::NotComputable(otherwise);
  return {lu.solve(right.on_state), right.on_input.cols() > 0 ? lu.solve(right.on_input) : right.on_input};
}

}  // namespace

InputDerivatives all_derivatives(const InputVector& w, double kappa) {
  InputDerivatives u;
  u.head<5>() = w;
  for (Eigen::Index m = 5; m < input_derivatives; ++m) u(m) = -kappa * kappa * u(m - 2);
  return u;
}

StateSpace::StateSpace(const numerics::DynamicMatrices& matrices, const std::vector<Drive>& courses) {
  const StateBasis basis = state_basis(matrices);
  const Eigen::Index n = basis.massive, z = basis.lagging, y = basis.following, N = 2 * n + z;
  const auto inputs = to_index(courses.size()) * input_derivatives;
  massive_ = n;
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(n + z + y, inputs);
  for (std::size_t c = 0; c < courses.size(); ++c)
    h.middleCols<5>(to_index(c) * input_derivatives) = basis.T.transpose() * courses[c].force;

  const Eigen::MatrixXd &B = basis.B, &K = basis.K;
  const Eigen::VectorXd lag_scale =
      K.block(n, n, z, z).diagonal().unaryExpr([](double k) { return k != 0 ? std::sqrt(std::abs(k)) : 1.0; });
  const auto part = [&](const Eigen::MatrixXd& m, Eigen::Index i, Eigen::Index rows, Eigen::Index j,
                        Eigen::Index columns) -> Eigen::MatrixXd { return m.block(i, j, rows, columns); };
  const auto of_state = [&](Eigen::Index first, const Eigen::VectorXd& scale) -> LinearRows {
    LinearRows rows{Eigen::MatrixXd::Zero(scale.size(), N), Eigen::MatrixXd::Zero(scale.size(), inputs)};
    rows.on_state.middleCols(first, scale.size()).diagonal() = scale.cwiseInverse();
    return rows;
  };
  const auto load = [&](Eigen::Index first, Eigen::Index rows) -> LinearRows {
    if (inputs == 0) return {Eigen::MatrixXd::Zero(rows, N), Eigen::MatrixXd::Zero(rows, 0)};
    return {Eigen::MatrixXd::Zero(rows, N), h.middleRows(first, rows)};
  };
  const LinearRows p = of_state(0, basis.speed), v = of_state(n, Eigen::VectorXd::Ones(n)),
                   lag = of_state(2 * n, lag_scale);
  const LinearRows follow = solved(part(K, n + z, y, n + z, y),
                                   load(n + z, y) + -(part(K, n + z, y, 0, n) * p) + -(part(K, n + z, y, n, z) * lag),
                                   "a coordinate has neither mass, nor damping, nor stiffness of its own");
  const LinearRows lag_rate = solved(part(B, n, z, n, z),
                                     load(n, z) + -(part(K, n, z, 0, n) * p) + -(part(B, n, z, 0, n) * v) +
                                         -(part(K, n, z, n, z) * lag) + -(part(K, n, z, n + z, y) * follow),
                                     "the damping of coordinates without mass is singular");
  const LinearRows acceleration =
      solved(basis.A,
             load(0, n) + -(part(K, 0, n, 0, n) * p) + -(part(B, 0, n, 0, n) * v) + -(part(K, 0, n, n, z) * lag) +
                 -(part(B, 0, n, n, z) * lag_rate) + -(part(K, 0, n, n + z, y) * follow),
             "the mass matrix is singular");

  groups_.dense = {N};
  F_ = Eigen::MatrixXd::Zero(N, N);
  F_.topRows(n) = basis.speed.asDiagonal() * v.on_state;
  F_.middleRows(n, n) = acceleration.on_state;
  F_.bottomRows(z) = lag_scale.asDiagonal() * lag_rate.on_state;
  for (std::size_t c = 0; c < courses.size(); ++c) {
    const Eigen::Index first = to_index(c) * input_derivatives;
    InputMatrix g = InputMatrix::Zero(N, 5);
    g.middleRows(n, n) = acceleration.on_input.middleCols<5>(first);
    g.bottomRows(z) = lag_scale.asDiagonal() * lag_rate.on_input.middleCols<5>(first);
    G_.push_back(g);
  }
  const Eigen::MatrixXd &T = basis.T, P = T.leftCols(n), Z = T.middleCols(n, z), Y = T.rightCols(y);
  displacements_ = P * p + Z * lag + Y * follow;
  from_displacement_ = from_velocity_ = Eigen::MatrixXd::Zero(N, T.rows());
  from_displacement_.topRows(n) = basis.speed.asDiagonal() * basis.from_coordinates.topRows(n);
  from_displacement_.bottomRows(z) = lag_scale.asDiagonal() * basis.from_coordinates.middleRows(n, z);
  from_velocity_.middleRows(n, n) = basis.from_coordinates.topRows(n);
  if (!basis.modal) return;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!(basis.K(i, i) * basis.A(i, i) > 0)) continue;
    StateMode mode{basis.speed(i), i, {}};
    for (std::size_t c = 0; c < courses.size(); ++c)
      mode.forces.push_back(h.row(i).segment<5>(to_index(c) * input_derivatives).transpose());
    modes_.push_back(std::move(mode));
  }
}

StateSpace StateSpace::decoupled() const {
  if (size() == 0) return *this;
  const numerics::PairForm form = numerics::pair_form(F_, numerics::lane_group);
  StateSpace space = *this;
  space.groups_ = form.groups;
  space.F_ = form.D;
  for (InputMatrix& g : space.G_) g = (form.Y * g).eval();
  space.displacements_.on_state = displacements_.on_state * form.X;
  space.from_displacement_ = form.Y * from_displacement_;
  space.from_velocity_ = form.Y * from_velocity_;
  space.modes_.clear();
  return space;
}

LinearRows StateSpace::derivative(const LinearRows& rows) const {
  assert(rows.on_state.cols() == size());
  LinearRows d{rows.on_state * F_, Eigen::MatrixXd::Zero(rows.on_input.rows(), rows.on_input.cols())};
  for (std::size_t c = 0; c < G_.size(); ++c) {
    const Eigen::Index first = to_index(c) * input_derivatives;
    d.on_input.middleCols(first + 1, input_derivatives - 1) = rows.on_input.middleCols(first, input_derivatives - 1);
    d.on_input.middleCols<5>(first) += rows.on_state * G_[c];
  }
  return d;
}

Eigen::VectorXd StateSpace::state(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) const {
  return from_displacement_ * displacement + from_velocity_ * velocity;
}

Eigen::VectorXd StateSpace::jump(std::size_t course, const InputVector& jump) const {
  assert(course < G_.size());
  const InputMatrix& g = G_[course];
  const Eigen::VectorXd of_velocity = g.col(of_value + 1), of_acceleration = g.col(of_value + 2);
  return (of_velocity + F_ * of_acceleration) * jump(of_value) + of_acceleration * jump(of_value + 1);
}

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
