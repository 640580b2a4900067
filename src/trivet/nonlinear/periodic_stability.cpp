// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/periodic_stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/answers_of_laws.h"
#include "trivet/numerics/linalg/general_eigen.h"
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
    values_.row(j) = deflections[to_size(j)].on_coordinates.transpose() * states.displacements().on_state;
    rates_.row(j) = deflections[to_size(j)].on_coordinates.transpose() * velocities;
  }
  constexpr double round_off = 1e-12;
  const double at_once = (values_ * force_).cwiseAbs().maxCoeff();
  if (at_once > round_off * values_.cwiseAbs().maxCoeff() * force_.cwiseAbs().maxCoeff())
    throw foundation::NotComputable("stability: a nonlinear part acts on a node without mass; give the node a mass");
  accelerations_ = (values_ * F_ * force_).diagonal();
  flow_ = numerics::LinearFlow(F_);
  if (!flow_.is_diagonalizable()) return;
  kick_ = flow_.from_states() * force_;
  seen_ = values_ * flow_.to_states();
  seen_rates_ = rates_ * flow_.to_states();
}

MatrixXd PeriodicStability::with_constant_tangents(const LawsAlong& motion, double from, double to) const {
  TangentsAlong tangent;
  set_tangents(motion, (from + to) / 2, tangent);
  const Index n = F_.rows();
  const MatrixXd forces = tangent.forces(motion, values_, rates_);
  MatrixXd F = MatrixXd::Zero(forces.cols(), forces.cols());
  F.topRows(n) = force_ * forces;
  F.topLeftCorner(n, n) += F_;
  const auto [found, is_new] = flows_.try_emplace(tangent.list(), numerics::LinearFlow(MatrixXd()));
  if (is_new) found->second = numerics::LinearFlow(F);
  return flow_over(found->second, F, (to - from) / motion.omega);
}

/// `answers_of_laws` without dampers and memory.
numerics::RowMatrix PeriodicStability::elastic_answers(const LawsAlong& motion, double from, double to,
                                                       int steps) const {
  const double phase_step = (to - from) / steps, step = phase_step / motion.omega;
  MatrixXd of_piece;
  const bool whole = from == 0 && to == two_pi;
  constexpr std::size_t most_kept = 32;
  if (rows_.size() > most_kept) rows_.clear();
  MatrixXd& rows = whole ? rows_[{steps, motion.harmonics}] : of_piece;
  if (rows.size() == 0) {
    rows.resize(steps, numerics::coefficient_count(motion.harmonics));
    for (int i = 0; i < steps; ++i)
      rows.row(i) = numerics::fourier_row(motion.harmonics, from + (i + 0.5) * phase_step);
  }
  const Index m = force_.cols();
  numerics::RowMatrix all = numerics::RowMatrix::Zero(m * steps, m);
  for (Index j = 0; j < m; ++j) {
    const VectorXd tangents = step * motion.courses[to_size(j)].elastic_tangents(rows);
    for (int i = 0; i < steps; ++i) all(i * m + j, j) = tangents(i);
  }
  return all;
}

MatrixXd PeriodicStability::split(const LawsAlong& motion, double from, double to, int steps) const {
  const double step = (to - from) / steps / motion.omega;
  const Index n = F_.rows(), m = force_.cols(), memory = motion.memories(), all = n + memory,
              carried = motion.carried(), rates = motion.is_damped() ? m : 0;
  const bool in_modes = flow_.is_diagonalizable();
  numerics::LinearFlow::Kicks kicks{
      numerics::RowMatrix::Zero(all, m + carried), numerics::RowMatrix::Zero(m + rates + memory, all),
      motion.is_elastic() ? elastic_answers(motion, from, to, steps)
                          : answers_of_laws(motion, rates_ * force_, accelerations_, from, to, steps)};
  kicks.kick.topLeftCorner(n, m) = in_modes ? kick_ : force_;
  kicks.kick.bottomRightCorner(carried, carried).setIdentity();
  kicks.seen.topLeftCorner(m, n) = in_modes ? seen_ : values_;
  if (rates > 0) kicks.seen.block(m, 0, m, n) = in_modes ? seen_rates_ : rates_;
  kicks.seen.bottomRightCorner(memory, memory).setIdentity();
  numerics::RowMatrix y = numerics::RowMatrix::Identity(all, all);
  if (in_modes) {
    y.topLeftCorner(n, n) = flow_.from_states();
    flow_.apply_with_kicks(step, kicks, y);
    y.topRows(n) = (flow_.to_states() * y.topRows(n)).eval();
    return y;
  }
  const MatrixXd half = response::ExponentialStep(F_, step / 2, 0).state(0);
  for (int i = 0; i < steps; ++i) {
    y.topRows(n) = (half * y.topRows(n)).eval();
    y += (kicks.kick * (kicks.answers.middleRows(i * (m + carried), m + carried) * (kicks.seen * y))).eval();
    y.topRows(n) = (half * y.topRows(n)).eval();
  }
  return y;
}

PeriodicStability::Transition PeriodicStability::split(const LawsAlong& motion, double from, double to,
                                                       double accurate) const {
  constexpr int per_period = 16, most = 2048;
  // The coarsest steps turn the mass that a law holds by its tangent alone by about a fifth of its period.
  TangentsAlong middle;
  set_tangents(motion, (from + to) / 2, middle);
  VectorXd stiffness = middle.by_deflection;
  for (std::size_t h = 0; h < motion.loops.size(); ++h)
    stiffness(motion.loops[h].deflection) += middle.by_travel(to_index(h));
  for (std::size_t b = 0; b < motion.bristles.size(); ++b)
    stiffness(motion.bristles[b].deflection) += middle.bristles[b].by_bristle * middle.bristles[b].gain;
  for (std::size_t r = 0; r < motion.rubbings.size(); ++r)
    stiffness(motion.rubbings[r].on) += middle.rubbings[r].by_deflection.diagonal();
  const double squared = stiffness.cwiseProduct(accelerations_).cwiseAbs().maxCoeff(),
               turned = std::sqrt(squared) * (to - from) / motion.omega;
  constexpr double turned_in_step = 1.2;
  const int fewest = std::max({2, static_cast<int>(std::ceil(per_period * (to - from) / two_pi)),
                               static_cast<int>(std::ceil(std::min(most / 8.0, turned / turned_in_step)))});
  // Errors in h², h⁴, … are removed from left to right (Aitken, Neville), from fewer steps than doubling would take.
  constexpr std::array<int, 4> multiples = {2, 3, 4, 6};
  std::vector<double> steps;
  std::vector<MatrixXd> row;
  for (int factor = 1;; factor *= 4) {
    for (const int multiple : multiples) {
      const int count = fewest * factor * multiple / 2;
      std::vector<MatrixXd> next = {split(motion, from, to, count)};
      for (std::size_t k = 0; k < row.size(); ++k) {
        const double ratio = count / steps[steps.size() - 1 - k];
        next.push_back(next.back() + (next.back() - row[k]) / (ratio * ratio - 1));
      }
      steps.push_back(count);
      row = std::move(next);
      const std::size_t last = row.size() - 1;
      if (last == 0) continue;
      const double change = (row[last] - row[last - 1]).norm(), size = row[last].norm();
      if (change <= accurate * size) return {row.back()};
      if (count > most) return {row.back(), change / size};
    }
  }
}

/// At a turning point the memory of a loop becomes its deflection and force there.
void PeriodicStability::turn(const LawsAlong& motion, std::size_t loop, double phase, MatrixXd& states) const {
  const Index n = F_.rows(), row = n + 2 * to_index(loop);
  const LawsAlong::Loop& one = motion.loops[loop];
  const double deflection = motion.courses[to_size(one.deflection)].deflection_at(phase);
  constexpr double before = 1e-9;
  const elements::ForceOnTravel end =
      one.loop->at(one.loop->branch_at(phase > before ? phase - before : phase - before + two_pi), deflection);
  const Eigen::RowVectorXd turned = values_.row(one.deflection) * states.topRows(n);
  const Eigen::RowVectorXd force = end.by_travel * (turned - states.row(row)) + end.by_start * states.row(row + 1);
  states.row(row) = turned;
  states.row(row + 1) = force;
}

/// The instant at which a force jumps by J moves by dt: an impulse −J dt.
void PeriodicStability::jump(const LawsAlong& motion, std::size_t loop, double phase, MatrixXd& states) const {
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
void PeriodicStability::change_rubbing(const LawsAlong& motion, std::size_t rubbing, double phase,
                                       MatrixXd& states) const {
  const LawsAlong::Rubbing& one = motion.rubbings[rubbing];
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
void PeriodicStability::forget_unused(const LawsAlong& motion, MatrixXd& states) const {
  constexpr double soon = 1e-9;
  for (std::size_t r = 0; r < motion.rubbings.size(); ++r) {
    const LawsAlong::Rubbing& one = motion.rubbings[r];
    const RubbingLoop::State state = one.remembers() ? one.loop.state_at(soon) : RubbingLoop::State::open;
    if (state != RubbingLoop::State::sticks) states.middleRows(F_.rows() + motion.first_kept(r), 2).setZero();
    if (state != RubbingLoop::State::slips) states.row(F_.rows() + motion.first_carried(r)).setZero();
  }
}

PeriodicStability::Multipliers PeriodicStability::multipliers(const MachineLaws& laws, const VectorXd& deflections,
                                                              double omega, double accurate) const {
  const LawsAlong motion(laws, deflections, omega);
  std::vector<double> corners = {0, two_pi};
  for (const LawCourse& course : motion.courses)
    for (const double phase : course.all_corners()) corners.push_back(phase);
  for (const LawsAlong::Distance& one : motion.distances)
    for (const double phase : one.law->corners(one.course)) corners.push_back(phase);
  for (const LawsAlong::Rubbing& one : motion.rubbings)
    for (const RubbingLoop::Change& change : one.loop.changes()) corners.push_back(change.phase);
  std::sort(corners.begin(), corners.end());
  const Index all = F_.rows() + motion.memories();
  MatrixXd period = MatrixXd::Identity(all, all);
  double uncertainty = 0;
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
                                                        : split(motion, from, to, accurate);
    period = (piece.states * period).eval();
    uncertainty = std::max(uncertainty, piece.uncertainty);
  }
  const numerics::GeneralEigen found = numerics::general_eigenvalues(period);
  if (!found.converged) return {Eigen::VectorXcd::Constant(all, foundation::infinity), foundation::infinity};
  return {found.values, uncertainty};
}

}  // namespace trivet::nonlinear
