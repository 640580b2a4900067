// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/stability/periodic_stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/laws/periodic_laws.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/generalized_modes.h"
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

/// The nearest viscous machine: between modes i and j the damping φ_iᵀ K_loss φ_j / √(ω_i ω_j).
numerics::DynamicMatrices without_losses(numerics::DynamicMatrices matrices) {
  if (!matrices.lossy()) return matrices;
  const numerics::GeneralizedModes modes = numerics::generalized_modes(matrices.K, matrices.A, matrices.symmetric);
  std::vector<Index> moving;
  for (Index i = 0; i < modes.lambda.size(); ++i)
    if (modes.lambda(i) > 0) moving.push_back(i);
  const MatrixXd shapes = modes.shapes(Eigen::all, moving);
  const VectorXd lambda = modes.lambda(moving);
  const VectorXd share = lambda.array().pow(-0.25).matrix();
  const MatrixXd weighted = matrices.A * shapes;
  matrices.B += weighted * (share.asDiagonal() * (shapes.transpose() * matrices.K_loss * shapes) * share.asDiagonal()) *
      weighted.transpose();
  matrices.K_loss.resize(0, 0);
  return matrices;
}

/// Is the product of all multipliers exp(logarithm), if each is known up to an error?
bool agrees_with_liouville(const Eigen::VectorXcd& multipliers, double logarithm, double error) {
  constexpr double margin = 100, close = 1e-4;
  const double each = margin * error;
  double highest = 0, lowest = 0;
  for (const std::complex<double>& one : multipliers) {
    highest += std::log(std::abs(one) + each);
    lowest += std::abs(one) > each ? std::log(std::abs(one) - each) : -foundation::infinity;
  }
  const double round_off = close * (1 + std::abs(logarithm));
  return logarithm <= highest + round_off && logarithm >= lowest - round_off;
}

MatrixXd without_round_off(const MatrixXd& given, double size) {
  constexpr double round_off = 1e-12;
  return (given.array().abs() > round_off * size).select(given, 0.0);
}

}  // namespace

PeriodicStability::PeriodicStability(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections)
    : replaced_losses_(assembled.matrices.lossy()), flow_(MatrixXd()) {
  const Index n = assembled.matrices.size();
  std::vector<response::Drive> drives;
  for (const Deflection& deflection : deflections) {
    response::Drive drive{response::InputMatrix::Zero(n, 5), response::InputMatrix::Zero(assembled.ground.size(), 5)};
    drive.force.col(response::of_value) = -deflection.on_coordinates;
    drives.push_back(std::move(drive));
  }
  const response::StateSpace states(without_losses(assembled.matrices), drives);
  F_ = states.F();
  force_.resize(states.size(), to_index(deflections.size()));
  values_.resize(to_index(deflections.size()), states.size());
  rates_.resize(values_.rows(), values_.cols());
  const MatrixXd velocities = states.derivative(states.displacements()).on_state;
  for (Index j = 0; j < force_.cols(); ++j) {
    force_.col(j) = states.G(to_size(j)).col(response::of_value);
    values_.row(j) = deflections[j].on_coordinates.transpose() * states.displacements().on_state;
    rates_.row(j) = deflections[j].on_coordinates.transpose() * velocities;
  }
  deflection_response_.rates = rates_ * force_;
  deflection_response_.drifts =
      without_round_off(values_ * force_, values_.cwiseAbs().maxCoeff() * force_.cwiseAbs().maxCoeff());
  deflection_response_.at_once = MatrixXd::Zero(values_.rows(), values_.rows());
  if (n + states.massive() > states.size()) {  // coordinates with stiffness only
    for (Index j = 0; j < force_.cols(); ++j)
      for (Index i = 0; i < values_.rows(); ++i)
        deflection_response_.at_once(i, j) = deflections[i].on_coordinates.dot(
            states.displacements().on_input.col(j * response::input_derivatives + response::of_value));
    deflection_response_.at_once =
        without_round_off(deflection_response_.at_once, deflection_response_.at_once.cwiseAbs().maxCoeff());
  }
  deflection_response_.massless = !deflection_response_.drifts.isZero(0) || !deflection_response_.at_once.isZero(0);
  check_nodes(deflections);
  accelerations_ = deflection_response_.rates.diagonal();
  const VectorXd size = accelerations_.cwiseAbs().cwiseSqrt().unaryExpr([](double one) { return one > 0 ? one : 1.0; });
  alike_ = size.cwiseInverse().asDiagonal() * deflection_response_.rates * size.asDiagonal();
  flow_ = numerics::LinearFlow(F_);
  if (!flow_.is_diagonalizable()) return;
  kick_ = flow_.from_states() * force_;
  seen_ = values_ * flow_.to_states();
  seen_rates_ = rates_ * flow_.to_states();
  // A real and an imaginary part each, which turn into each other.
  kicked_ = kick_.cwiseAbs();
  moved_ = seen_.cwiseAbs();
  for (Index i = 0; i + 1 < F_.rows(); ++i) {
    if (!(flow_.turning()(i) > 0)) continue;
    kicked_.row(i) += kicked_.row(i + 1).eval();
    moved_.col(i) += moved_.col(i + 1).eval();
  }
}

MatrixXd PeriodicStability::with_constant_tangents(const PeriodicLaws& motion, double from, double to) const {
  TangentsAlong tangent;
  set_tangents(motion, (from + to) / 2, tangent);
  const Index n = F_.rows();
  MatrixXd forces = tangent.forces(motion, values_, rates_);
  if (deflection_response_.massless) {
    const MatrixXd left = deflection_response_.left_side(tangent.stiffness(motion), tangent.damping(motion), 0);
    forces = numerics::PivotedLu<double>(left).solve(forces);
  }
  MatrixXd F = MatrixXd::Zero(forces.cols(), forces.cols());
  F.topRows(n) = force_ * forces;
  F.topLeftCorner(n, n) += F_;
  const auto [found, is_new] = flows_.try_emplace(tangent.list(), numerics::LinearFlow(MatrixXd()));
  if (is_new) found->second = numerics::LinearFlow(F);
  return flow_over(found->second, F, (to - from) / motion.omega);
}

/// Laws that depend on rates need masses or dampers to act on, and forces that jump or rub need masses.
void PeriodicStability::check_nodes(const std::vector<Deflection>& deflections) const {
  for (std::size_t j = 0; j < deflections.size(); ++j) {
    const Deflection& one = deflections[j];
    const Index row = to_index(j);
    const auto is_massless = [&](Index i) {
      return !deflection_response_.drifts.row(i).isZero(0) || !deflection_response_.at_once.row(i).isZero(0);
    };
    const bool jumps =
        std::ranges::any_of(one.law.hysteretic(), [](const auto& part) { return elements::jumps_at_turns(part.law); });
    const bool rubs = one.rubbing && (is_massless(row) || is_massless(row + 1)),
               depends_on_rate = one.law.has_dampers() || !one.law.of_amplitude().empty() ||
        (one.distance && one.distance->has_dampers());
    const bool follows = !deflection_response_.at_once.row(row).isZero(0) ||
        (one.distance && !deflection_response_.at_once.middleRows(row, 3).isZero(0));
    const char* what = (depends_on_rate && follows)                 ? "depends on its rate"
        : jumps && is_massless(row)                                 ? "is friction without a spring"
        : rubs || (!one.law.bristles().empty() && is_massless(row)) ? "is friction that turns or has bristles"
                                                                    : nullptr;
    if (what)
      throw foundation::NotComputable(
          fmt::format("stability: {} {} and acts on a node, which has no mass; make the node a body with the mass of "
                      "the part that it stands for{}",
                      one.name, what, depends_on_rate && follows ? ", or give its elements damping" : ""));
  }
}

/// Variation of a deflection at a phase, by the states and memories; that of a node follows by its balance of forces.
Eigen::RowVectorXd PeriodicStability::deflection(const PeriodicLaws& motion, Index j, double phase,
                                                 const MatrixXd& states) const {
  const Eigen::RowVectorXd by_states = values_.row(j) * states.topRows(F_.rows());
  if (deflection_response_.at_once.row(j).isZero(0)) return by_states;
  TangentsAlong tangent;
  set_tangents(motion, phase > 0 ? phase : phase + two_pi, tangent);
  const MatrixXd stiffness = tangent.stiffness(motion), damping = tangent.damping(motion);
  MatrixXd forces = (stiffness * values_ + damping * rates_) * states.topRows(F_.rows());
  for (std::size_t h = 0; h < motion.loops.size(); ++h) {
    const Index row = F_.rows() + 2 * to_index(h);
    forces.row(motion.loops[h].deflection) -= tangent.by_travel(to_index(h)) * states.row(row);
    forces.row(motion.loops[h].deflection) += tangent.by_start(to_index(h)) * states.row(row + 1);
  }
  return by_states +
      deflection_response_.at_once.row(j) *
      numerics::PivotedLu<double>(deflection_response_.left_side(stiffness, damping, 0)).solve(forces);
}

/// At a turning point the memory of a loop becomes its deflection and force there.
void PeriodicStability::turn(const PeriodicLaws& motion, std::size_t loop, double phase, MatrixXd& states) const {
  const Index n = F_.rows(), row = n + 2 * to_index(loop);
  assert(loop < motion.loops.size() && states.rows() == n + motion.memories());
  const PeriodicLaws::Loop& one = motion.loops[loop];
  const double deflection = motion.courses[one.deflection].deflection_at(phase);
  constexpr double before = 1e-9;
  const elements::ForceOnTravel end =
      one.loop->at(one.loop->branch_at(phase > before ? phase - before : phase - before + two_pi), deflection);
  const Eigen::RowVectorXd turned = this->deflection(motion, one.deflection, phase - before, states);
  const Eigen::RowVectorXd force = end.by_travel * (turned - states.row(row)) + end.by_start * states.row(row + 1);
  states.row(row) = turned;
  states.row(row + 1) = force;
}

/// The instant at which a force jumps by J moves by dt: an impulse −J dt.
void PeriodicStability::jump(const PeriodicLaws& motion, std::size_t loop, double phase, MatrixXd& states) const {
  const Index n = F_.rows(), row = n + 2 * to_index(loop), j = motion.loops[loop].deflection;
  for (const HystereticLoop::Jump& one : motion.loops[loop].jumps) {
    if (std::fmod(one.phase, two_pi) != phase) continue;
    Eigen::RowVectorXd later;
    if (one.by_slope != 0) {
      // The motion of the harmonics has the mean acceleration there.
      const double mean = -motion.omega * motion.omega / one.by_slope,
                   before = mean - one.force / 2 * accelerations_(j);
      later = -rates_.row(j) * states.topRows(n) / before;
    } else {
      later = (one.by_deflection * (values_.row(j) * states.topRows(n) - states.row(row)) +
               one.by_start * states.row(row + 1)) /
          motion.omega;
    }
    states.topRows(n) -= one.force * force_.col(j) * later;
  }
}

/// Where a rubbing contact begins to stick, to slip or to open, the variation of its force is the same on both sides;
/// where it closes and sticks, its springs begin at another place if it closes earlier.
void PeriodicStability::change_rubbing(const PeriodicLaws& motion, std::size_t rubbing, double phase,
                                       MatrixXd& states) const {
  assert(rubbing < motion.rubbings.size() && states.rows() == F_.rows() + motion.memories());
  const PeriodicLaws::Rubbing& one = motion.rubbings[rubbing];
  const Index n = F_.rows(), kept = motion.first_kept(rubbing) + n, carried = motion.first_carried(rubbing) + n;
  const double k = one.loop.law().law().stiffness, unit = units_of_friction(motion, accelerations_)(to_index(rubbing));
  for (const RubbingLoop::Change& change : one.loop.changes()) {
    if (change.phase != phase) continue;
    const ContactFrame& frame = change.frame;
    const MatrixXd deflections = values_(one.on, Eigen::all) * states.topRows(n), across = frame.on_wall * deflections;
    const Eigen::RowVectorXd shrinks = frame.curvature * change.friction.x() * frame.normal * deflections;
    const double size = change.friction.norm();
    const Eigen::Vector2d direction = size > 0 ? Eigen::Vector2d(change.friction / size) : Eigen::Vector2d::Zero(),
                          aside(-direction.y(), direction.x());
    MatrixXd friction = MatrixXd::Zero(2, states.cols());
    if (change.before == RubbingLoop::State::sticks) {
      friction = unit * states.middleRows(kept, 2) + k * across;
      friction.row(0) = frame.hoop * friction.row(0) - shrinks;
    }
    const Eigen::RowVectorXd limit =
        (change.limit.by_deflection * frame.normal + change.limit.by_rate * motion.omega * change.rates.normal) *
            deflections +
        change.limit.by_rate * frame.normal * (rates_(one.on, Eigen::all) * states.topRows(n));
    if (change.before == RubbingLoop::State::slips) friction = direction * limit + unit * aside * states.row(carried);
    states.middleRows(kept, 2).setZero();
    states.row(carried).setZero();
    if (change.after == RubbingLoop::State::slips) states.row(carried) = aside.transpose() * friction / unit;
    if (change.after != RubbingLoop::State::sticks) continue;
    friction.row(0) = (friction.row(0) + shrinks) / frame.hoop;
    states.middleRows(kept, 2) = (friction - k * across) / unit;
    states.middleRows(kept, 2) += k / unit * change.travel_by_limit * limit;
  }
}

/// Memories of rubbing contacts that are in use at the start of a period; others would have the multiplier 1.
void PeriodicStability::forget_unused(const PeriodicLaws& motion, MatrixXd& states) const {
  constexpr double soon = 1e-9;
  for (std::size_t r = 0; r < motion.rubbings.size(); ++r) {
    const PeriodicLaws::Rubbing& one = motion.rubbings[r];
    const RubbingLoop::State state = one.remembers() ? one.loop.state_at(soon) : RubbingLoop::State::open;
    if (state != RubbingLoop::State::sticks) states.middleRows(F_.rows() + motion.first_kept(r), 2).setZero();
    if (state != RubbingLoop::State::slips) states.row(F_.rows() + motion.first_carried(r)).setZero();
  }
}

PeriodicStability::Multipliers PeriodicStability::multipliers(const LawSet& laws, const VectorXd& deflections,
                                                              double omega, double accurate) const {
  const PeriodicLaws motion(laws, deflections, omega);
  // Undamped, all multipliers of stable motions are on the unit circle: they must not seem outside.
  constexpr double on_circle = 1e-9;
  if (is_undamped() && !motion.is_damped()) accurate = std::min(accurate, on_circle);
  std::vector<double> corners = {0, two_pi};
  for (const LawOverPeriod& course : motion.courses)
    for (const double phase : course.all_corners()) corners.push_back(phase);
  for (const PeriodicLaws::Distance& one : motion.distances)
    for (const double phase : one.law->corners(one.course)) corners.push_back(phase);
  for (const PeriodicLaws::Rubbing& one : motion.rubbings)
    for (const RubbingLoop::Change& change : one.loop.changes()) corners.push_back(change.phase);
  std::ranges::sort(corners);
  assert(corners.front() == 0 && corners.back() == two_pi && "all phases are within one period");
  const Index all = F_.rows() + motion.memories();
  MatrixXd period = MatrixXd::Identity(all, all);
  constexpr double exact = 1e-9;  // share of the transition by closed form, with nearly dependent eigenvectors
  double uncertainty = 0, logarithm = 0;
  forget_unused(motion, period);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double from = corners[i], to = corners[i + 1];
    for (std::size_t h = 0; h < motion.loops.size(); ++h)
      for (const HystereticLoop::Branch& branch : motion.loops[h].loop->branches())
        if (branch.from == from && (i == 0 || corners[i - 1] != from)) turn(motion, h, from, period);
    if (i == 0 || corners[i - 1] != from)
      for (std::size_t h = 0; h < motion.loops.size(); ++h) jump(motion, h, from, period);
    if (i == 0 || corners[i - 1] != from)
      for (std::size_t r = 0; r < motion.rubbings.size(); ++r) change_rubbing(motion, r, from, period);
    constexpr double nothing = 1e-12;
    if (to - from < nothing) continue;
    const Transition piece = motion.is_piecewise_linear ? Transition{with_constant_tangents(motion, from, to)}
                                                        : smooth(motion, from, to, accurate);
    period = (piece.states * period).eval();
    uncertainty = std::max(uncertainty, piece.uncertainty);
    if (motion.memories() == 0) logarithm += trace(motion, from, to);
  }
  const numerics::GeneralEigen found = numerics::general_eigenvalues(period);
  if (!found.converged) return {Eigen::VectorXcd::Constant(all, foundation::infinity), foundation::infinity, false};
  // Memories are forces and deflections in one matrix: its norm would depend on their units, the multipliers do not.
  const double size = motion.memories() > 0 ? std::max(1.0, found.values.cwiseAbs().maxCoeff()) : period.norm();
  const double error = size * (motion.is_piecewise_linear ? exact : std::max({accurate, exact, uncertainty}));
  constexpr double most = 1e-3;  // beyond, all but the largest multipliers are round-off
  const bool confirmed =
      motion.memories() > 0 ? error < most : error < most && agrees_with_liouville(found.values, logarithm, error);
  return {found.values, uncertainty, confirmed};
}

}  // namespace trivet::nonlinear
