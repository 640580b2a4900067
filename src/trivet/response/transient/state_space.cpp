// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/state_space.h"

#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/recurrence/pair_steps.h"
#include "trivet/response/transient/state_basis.h"

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

}  // namespace trivet::response
