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

PeriodicStability::PeriodicStability(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections) {
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
}

MatrixXd PeriodicStability::transition(const std::vector<LawHarmonics>& laws, const VectorXd& deflections, double from,
                                       double to, double omega, int steps) const {
  const double phase_step = (to - from) / steps, step = phase_step / omega;
  const MatrixXd half = response::ExponentialStep(F_, step / 2, 0).state(0), whole = half * half;
  const Index C = deflections.size() / force_.cols();
  MatrixXd result = half;
  for (int i = 0; i < steps; ++i) {
    const double phase = from + (i + 0.5) * phase_step;
    VectorXd tangent(force_.cols());
    for (Index j = 0; j < tangent.size(); ++j) {
      const double deflection = numerics::motion_at((C - 1) / 2, phase, deflections.segment(j * C, C));
      tangent(j) = laws[to_size(j)].law().at(deflection).tangent;
    }
    result += step * force_ * (tangent.asDiagonal() * (values_ * result));
    result = ((i + 1 < steps ? whole : half) * result).eval();
  }
  return result;
}

Eigen::VectorXcd PeriodicStability::multipliers(const std::vector<LawHarmonics>& laws, const VectorXd& deflections,
                                                double omega) const {
  const Index C = deflections.size() / force_.cols();
  std::vector<double> corners = {0, two_pi};
  for (Index j = 0; j < force_.cols(); ++j)
    for (const double phase : laws[to_size(j)].kink_phases(deflections.segment(j * C, C))) corners.push_back(phase);
  std::sort(corners.begin(), corners.end());
  constexpr int per_period = 48;
  MatrixXd period = MatrixXd::Identity(F_.rows(), F_.cols());
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double from = corners[i], to = corners[i + 1];
    if (to - from < 1e-14) continue;
    const int steps = std::max(4, static_cast<int>(std::ceil(per_period * (to - from) / two_pi)));
    const MatrixXd coarse = transition(laws, deflections, from, to, omega, steps),
                   middle = transition(laws, deflections, from, to, omega, 2 * steps),
                   fine = transition(laws, deflections, from, to, omega, 4 * steps);
    const MatrixXd first = (4 * middle - coarse) / 3, second = (4 * fine - middle) / 3;  // errors h², h⁴ removed
    period = ((16 * second - first) / 15 * period).eval();
  }
  return numerics::general_eigenvalues(period).values;
}

}  // namespace trivet::nonlinear
