// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/periodic_stability.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/general_eigen.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/response/transient/exponential_step.h"
#include "trivet/response/transient/state_space.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;

namespace {

/// Flow by the eigenvalues, or by scaling and squaring if the eigenvectors are nearly dependent.
MatrixXd flow_over(const numerics::LinearFlow& flow, const MatrixXd& F, double time) {
  return flow.is_diagonalizable() ? flow.at(time) : MatrixXd(response::ExponentialStep(F, time, 0).state(0));
}

}  // namespace

PeriodicStability::PeriodicStability(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections)
    : flow_(MatrixXd()) {
  if (assembled.matrices.lossy())
    throw foundation::NotComputable(
        "stability with loss factors: they define no motion in time; replace them by viscous damping");
  const Index n = assembled.matrices.size();
  std::vector<response::Drive> drives;
  for (const Deflection& deflection : deflections) {
    response::Drive drive{response::InputMatrix::Zero(n, 5), response::InputMatrix::Zero(assembled.ground.size(), 5)};
    drive.force.col(response::of_value) = -deflection.on_coordinates;
    drives.push_back(std::move(drive));
  }
  const response::StateSpace states(assembled.matrices, drives);
  F_ = states.F();
  force_.resize(states.size(), to_index(deflections.size()));
  values_.resize(to_index(deflections.size()), states.size());
  for (Index j = 0; j < force_.cols(); ++j) {
    force_.col(j) = states.G(to_size(j)).col(response::of_value);
    values_.row(j) = deflections[to_size(j)].on_coordinates.transpose() * states.displacements().on_state;
  }
  constexpr double round_off = 1e-12;
  const double at_once = (values_ * force_).cwiseAbs().maxCoeff();
  if (at_once > round_off * values_.cwiseAbs().maxCoeff() * force_.cwiseAbs().maxCoeff())
    throw foundation::NotComputable("stability: a nonlinear part acts on a node without mass; give the node a mass");
  flow_ = numerics::LinearFlow(F_);
  if (!flow_.is_diagonalizable()) return;
  kick_ = flow_.from_states() * force_;
  seen_ = values_ * flow_.to_states();
}

VectorXd PeriodicStability::tangents(const Laws& laws, const VectorXd& deflections, double phase) const {
  const Index C = deflections.size() / force_.cols();
  VectorXd found(force_.cols());
  for (Index j = 0; j < found.size(); ++j)
    found(j) =
        laws[to_size(j)].law().at(numerics::motion_at((C - 1) / 2, phase, deflections.segment(j * C, C))).tangent;
  return found;
}

MatrixXd PeriodicStability::with_constant_tangents(const Laws& laws, const VectorXd& deflections, double from,
                                                   double to, double omega) const {
  const VectorXd tangent = tangents(laws, deflections, (from + to) / 2);
  const MatrixXd F = F_ + force_ * tangent.asDiagonal() * values_;
  const auto [found, is_new] =
      flows_.try_emplace(std::vector<double>(tangent.begin(), tangent.end()), numerics::LinearFlow(MatrixXd()));
  if (is_new) found->second = numerics::LinearFlow(F);
  return flow_over(found->second, F, (to - from) / omega);
}

MatrixXd PeriodicStability::split(const Laws& laws, const VectorXd& deflections, double from, double to, double omega,
                                  int steps) const {
  const double phase_step = (to - from) / steps, step = phase_step / omega;
  const Index n = F_.rows(), m = force_.cols();
  const bool in_modes = flow_.is_diagonalizable();
  const MatrixXd &kick = in_modes ? kick_ : force_, &seen = in_modes ? seen_ : values_;
  numerics::LinearFlow::Step half, whole;
  MatrixXd dense_half, dense_whole;
  if (in_modes) {
    half = flow_.step(step / 2);
    whole = flow_.step(step);
  } else {
    dense_half = response::ExponentialStep(F_, step / 2, 0).state(0);
    dense_whole = dense_half * dense_half;
  }
  const auto flow = [&](bool by_whole, MatrixXd& y) {
    if (in_modes) flow_.apply(by_whole ? whole : half, y);
    else y = (by_whole ? dense_whole : dense_half) * y;
  };
  MatrixXd result = MatrixXd::Identity(n, n);
  flow(false, result);
  MatrixXd moved(m, n);
  for (int i = 0; i < steps; ++i) {
    const VectorXd tangent = step * tangents(laws, deflections, from + (i + 0.5) * phase_step);
    moved.noalias() = seen * result;
    moved = (tangent.asDiagonal() * moved).eval();
    result.noalias() += kick * moved;
    flow(i + 1 < steps, result);
  }
  return in_modes ? MatrixXd(flow_.to_states() * result * flow_.from_states()) : result;
}

MatrixXd PeriodicStability::split(const Laws& laws, const VectorXd& deflections, double from, double to,
                                  double omega) const {
  constexpr int per_period = 32, most = 512;
  constexpr double accurate = 1e-7;  // change by the last extrapolation, which is that of the result without it
  int steps = std::max(4, static_cast<int>(std::ceil(per_period * (to - from) / two_pi)));
  MatrixXd coarse = split(laws, deflections, from, to, omega, steps),
           middle = split(laws, deflections, from, to, omega, 2 * steps);
  for (;;) {
    const MatrixXd fine = split(laws, deflections, from, to, omega, 4 * steps);
    const MatrixXd first = (4 * middle - coarse) / 3, second = (4 * fine - middle) / 3;  // errors h², h⁴ removed
    const MatrixXd found = (16 * second - first) / 15;
    steps *= 2;
    if ((found - second).norm() <= accurate * found.norm() || steps > most) return found;
    coarse = std::move(middle);
    middle = fine;
  }
}

Eigen::VectorXcd PeriodicStability::multipliers(const Laws& laws, const VectorXd& deflections, double omega) const {
  const Index C = deflections.size() / force_.cols();
  std::vector<double> corners = {0, two_pi};
  bool constant = true;
  for (Index j = 0; j < force_.cols(); ++j) {
    for (const double phase : laws[to_size(j)].kink_phases(deflections.segment(j * C, C))) corners.push_back(phase);
    constant = constant && laws[to_size(j)].law().is_piecewise_linear();
  }
  std::sort(corners.begin(), corners.end());
  MatrixXd period = MatrixXd::Identity(F_.rows(), F_.cols());
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double from = corners[i], to = corners[i + 1];
    if (to - from < 1e-14) continue;
    period = ((constant ? with_constant_tangents(laws, deflections, from, to, omega)
                        : split(laws, deflections, from, to, omega)) *
              period)
                 .eval();
  }
  return numerics::general_eigenvalues(period).values;
}

}  // namespace trivet::nonlinear
