// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/balance/steady_equations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/lane_lu.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Of the same kind: translations or rotations.
VectorXd carried_with_independent(const DeflectionBasis& basis, const std::vector<Deflection>& deflections) {
  VectorXd found = VectorXd::Zero(basis.size());
  for (Index b = 0; b < basis.size(); ++b)
    for (Index j = 0; j < basis.spread.cols(); ++j)
      if (deflections[j].is_rotation == deflections[basis.independent[b]].is_rotation)
        found(b) += basis.spread(b, j) * basis.spread(b, j);
  return found.cwiseSqrt();
}

}  // namespace

SteadyEquations::SteadyEquations(const CondensedMachine& machine, const std::vector<Deflection>& deflections,
                                 const PeriodicExcitation& excitation, const SteadyOptions& options, Index harmonics)
    : options_(options),
      first_harmonic_(excitation.first_harmonic),
      of_shaft_(excitation.of_shaft),
      balance_(machine, deflections, harmonics) {
  constexpr double share = 1e-3;
  carried_ = carried_with_independent(machine.basis(), deflections);
  const VectorXd motion = balance_.linear_motion(driving(options_.from));
  smallest_ = share * balance_.largest_harmonics(motion);
  const auto vanish = [](const numerics::Load& load) {
    return std::ranges::all_of(load.terms(), [](const numerics::LoadTerm& term) { return term.value.isZero(0); });
  };
  const bool is_zero = std::ranges::all_of(excitation.loadings, [&](const assembly::Loading& loading) {
    return vanish(loading.force) && vanish(loading.motion);
  });
  if (is_zero) throw foundation::NotComputable("steady: the excitation is zero; give it an amplitude");
  if (motion.isZero(0))
    throw foundation::NotComputable(
        "steady: no excitation moves a nonlinear part, so that the motion is linear; take response");
}

Driving SteadyEquations::driving(double parameter) const {
  if (options_.over == Parameter::frequency) return {first_harmonic_ * parameter, 1};
  return {first_harmonic_ * options_.angular_frequency, parameter};
}

std::string SteadyEquations::place(double parameter) const {
  if (options_.over == Parameter::load_factor) return fmt::format("{:.10g} times the load", parameter);
  return of_shaft_ ? fmt::format("{:.10g} rpm", parameter * foundation::rpm_per_rad_s)
                   : fmt::format("{:.10g} Hz", parameter / foundation::two_pi);
}

VectorXd SteadyEquations::scale(const VectorXd& unknowns) const {
  constexpr double of_mean = 1e-4;
  const Index C = balance_.coefficients();
  const VectorXd mean = balance_.largest_means(unknowns);
  const VectorXd harmonic = balance_.largest_harmonics(unknowns).cwiseMax(smallest_).cwiseMax(of_mean * mean);
  VectorXd result(unknowns.size());
  for (Index j = 0; j < mean.size(); ++j) {
    result.segment(j * C, C).setConstant(harmonic(j) / carried_(j));
    result(j * C) = std::max(mean(j), harmonic(j)) / carried_(j);
  }
  return result;
}

numerics::Branch SteadyEquations::branch(numerics::EvaluateEquations evaluate, double width) const {
  return {std::move(evaluate), width, [this](const VectorXd& unknowns) { return scale(unknowns); }};
}

numerics::Branch SteadyEquations::branch() const {
  return branch(
      [this](const VectorXd& unknowns, double parameter, numerics::Equations& equations) {
        balance_.evaluate(unknowns, driving(parameter), options_.over, equations);
        if (options_.over == Parameter::frequency) equations.by_parameter *= first_harmonic_;
      },
      width());
}

numerics::Branch SteadyEquations::over_load(double parameter) const {
  return branch(
      [this, whole = driving(parameter)](const VectorXd& unknowns, double share, numerics::Equations& equations) {
        balance_.evaluate(unknowns, {whole.omega, share * whole.factor}, Parameter::load_factor, equations);
        equations.by_parameter *= whole.factor;
      },
      1);
}

numerics::Branch SteadyEquations::over_nonlinear_forces(double parameter) const {
  const Driving there = driving(parameter);
  return branch(
      [this, there, linear = balance_.linear_motion(there)](const VectorXd& unknowns, double share,
                                                            numerics::Equations& equations) {
        balance_.evaluate(unknowns, there, options_.over, equations);
        const VectorXd without = unknowns - linear;
        equations.by_parameter = equations.value - without;
        equations.value = without + share * equations.by_parameter;
        equations.by_unknowns *= share;
        equations.by_unknowns.diagonal().array() += 1 - share;
      },
      1);
}

/// Of the equations by the unknowns, both divided by the scale of the unknowns.
MatrixXd SteadyEquations::derivatives(const Place& place) const {
  numerics::Equations equations;
  balance_.evaluate(place.unknowns, driving(place.parameter), options_.over, equations);
  const VectorXd scales = scale(place.unknowns);
  return scales.cwiseInverse().asDiagonal() * equations.by_unknowns * scales.asDiagonal();
}

/// By inverse iteration; of an exactly singular matrix with its diagonal shifted.
std::optional<VectorXd> SteadyEquations::weakest_direction(const Place& place) const {
  constexpr int iterations = 6;
  constexpr double small = 1e-13;
  MatrixXd matrix = derivatives(place);
  for (const double shift : {0.0, small}) {
    matrix.diagonal().array() += shift;
    const numerics::LaneLu factors(matrix);
    VectorXd direction = VectorXd::LinSpaced(place.unknowns.size(), 1, 2).normalized();
    for (int i = 0; i < iterations && direction.allFinite(); ++i) direction = factors.solve(direction).normalized();
    if (!direction.allFinite()) continue;
    Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    return direction(largest) < 0 ? VectorXd(-direction) : direction;
  }
  return std::nullopt;
}

bool SteadyEquations::is_beyond_fold(const Place& place) const {
  return numerics::LaneLu(derivatives(place)).determinant_sign() < 0;
}

/// The derivatives D bordered by the direction d: [D d; dᵀ 0] [x; change] = [0; 1].
double SteadyEquations::change_along(const Place& place, const VectorXd& direction) const {
  const Index n = direction.size();
  MatrixXd bordered = MatrixXd::Zero(n + 1, n + 1);
  bordered.topLeftCorner(n, n) = derivatives(place);
  bordered.topRightCorner(n, 1) = direction;
  bordered.bottomLeftCorner(1, n) = direction.transpose();
  return numerics::LaneLu(bordered).solve(VectorXd::Unit(n + 1, n))(n);
}

}  // namespace trivet::nonlinear
