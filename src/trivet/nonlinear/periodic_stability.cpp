// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/periodic_stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/general_eigen.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
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

struct PeriodicStability::Motion {
  Motion(const MachineLaws& laws, const VectorXd& deflections, double frequency) : omega(frequency) {
    const std::vector<LawHarmonics>& single = laws.single();
    const Index C = deflections.size() / to_index(single.size());
    harmonics = (C - 1) / 2;
    for (std::size_t j = 0; j < single.size(); ++j) {
      courses.push_back(single[j].course(deflections.segment(to_index(j) * C, C), omega));
      is_piecewise_linear = is_piecewise_linear && single[j].law().is_piecewise_linear();
    }
    for (const MachineLaws::Distance& one : laws.distances()) {
      distances.push_back({one.first, &one.law, deflections.segment(one.first * C, 3 * C).reshaped(C, 3)});
      is_piecewise_linear = false;
    }
    for (const MachineLaws::Rubbing& one : laws.rubbings()) {
      RubbingLoop loop = laws.loop(one, deflections.reshaped(C, to_index(single.size())), omega);
      is_piecewise_linear = false;
      rubbings.push_back({one.along, one.across, std::move(loop)});
    }
    for (std::size_t j = 0; j < courses.size(); ++j)
      for (const HystereticLoop& loop : courses[j].loops())
        (loop.sticks() ? sticking : loops)
            .push_back({to_index(j), &loop, loop.jumps(deflections.segment(to_index(j) * C, C))});
    for (std::size_t j = 0; j < courses.size(); ++j)
      for (const BristleLoop& loop : courses[j].bristles())
        (loop.moves() ? bristles : stuck).push_back({to_index(j), &loop});
  }
  struct Loop {
    Index deflection;
    const HystereticLoop* loop;
    std::vector<HystereticLoop::Jump> jumps;
  };
  struct Bristles {
    Index deflection;
    const BristleLoop* loop;
  };
  /// Friction across a contact: with the two forces since it stuck, and the one across its slip.
  struct Rubbing {
    Index along, across;  ///< deflections
    RubbingLoop loop;
    [[nodiscard]] bool remembers() const { return !loop.points().empty() && !loop.always_sticks(); }
  };
  /// Memories that change only where something turns, and those that change all the time.
  [[nodiscard]] Index kept() const { return 2 * to_index(loops.size()) + 2 * to_index(rubbings.size()); }
  [[nodiscard]] Index carried() const { return to_index(bristles.size()) + to_index(rubbings.size()); }
  [[nodiscard]] Index memories() const { return kept() + carried(); }
  [[nodiscard]] bool is_damped() const {
    return std::any_of(courses.begin(), courses.end(), [](const LawCourse& course) { return course.is_damped(); }) ||
        std::any_of(distances.begin(), distances.end(),
                    [](const Distance& one) { return one.law->law().has_dampers(); }) ||
        !rubbings.empty();
  }
  [[nodiscard]] bool is_elastic() const {
    return !is_damped() && loops.empty() && sticking.empty() && distances.empty();
  }
  struct Distance {
    Index first;
    const DistanceHarmonics* law;
    MatrixXd course;  ///< coefficients × 3
  };
  double omega;
  Index harmonics = 0;
  bool is_piecewise_linear = true;
  std::vector<LawCourse> courses;
  std::vector<Loop> loops;     ///< with memory
  std::vector<Loop> sticking;  ///< as springs
  std::vector<Bristles> bristles, stuck;
  std::vector<Distance> distances;
  std::vector<Rubbing> rubbings;
};

/// Variation of the force of each deflection: by_deflection δ + by_rate δ̇ + Σ (by_travel (δ − δ_turn) + by_start
/// f_turn) of its loops, and of bristles, distances and rubbing contacts beside.
struct PeriodicStability::Tangents {
  VectorXd by_deflection, by_rate;
  VectorXd by_travel, by_start;  ///< one per loop
  Eigen::RowVectorXd row;        ///< of the Fourier basis
  std::vector<elements::SpatialForce> distances;
  std::vector<BristleLoop::Here> bristles;
  std::vector<RubbingLoop::Moment> rubbings;

  [[nodiscard]] std::vector<double> list() const {
    std::vector<double> all;
    for (const VectorXd* part : {&by_deflection, &by_rate, &by_travel, &by_start})
      all.insert(all.end(), part->begin(), part->end());
    return all;
  }
  /// Deflections × states: values, rates and memory to forces, of laws without bristles and distances.
  [[nodiscard]] MatrixXd forces(const Motion& motion, const MatrixXd& values, const MatrixXd& rates) const {
    const Index n = values.cols();
    MatrixXd rows = MatrixXd::Zero(values.rows(), n + 2 * by_travel.size());
    rows.leftCols(n) = by_deflection.asDiagonal() * values + by_rate.asDiagonal() * rates;
    for (Index h = 0; h < by_travel.size(); ++h) {
      const Index j = motion.loops[to_size(h)].deflection;
      rows.row(j).head(n) += by_travel(h) * values.row(j);
      rows(j, n + 2 * h) = -by_travel(h);
      rows(j, n + 2 * h + 1) = by_start(h);
    }
    return rows;
  }
};

namespace {

/// ẏ = source − decay y over a step h.
struct Fading {
  Fading(double decay, double h) {
    const double x = decay * h;
    constexpr double small = 1e-4;
    mean = std::abs(x) > small ? -std::expm1(-x) / x : 1 - x / 2;
    mean_of_integral = std::abs(x) > small ? (1 - mean) / x : 1.0 / 2 - x / 6;
    kept = std::exp(-x);
  }
  double kept;              ///< y at the end by that at the start
  double mean;              ///< of e^{−decay t}: y at the end by source · h, the mean of y by that at the start
  double mean_of_integral;  ///< the mean of y by source · h
};

/// Bristles over a step h with constant tangents and a constant variation of the rate: of their variation ζ̇ = gain δ̇ −
/// decay ζ, and the mean of their force.
struct BristleKick {
  BristleKick(const BristleLoop::Here& at, double h) {
    const Fading fading(at.decay, h);
    kept = fading.kept;
    grown = at.gain * fading.mean * h;
    by_start = at.by_bristle * fading.mean;
    by_rate = at.by_rate + at.by_bristle * at.gain * fading.mean_of_integral * h;
  }
  double kept = 0, grown = 0;        ///< ζ at the end by that at the start, and by the rate
  double by_start = 0, by_rate = 0;  ///< the mean force by ζ at the start, and by the rate
};

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

void PeriodicStability::set_tangents(const Motion& motion, double phase, Tangents& found) {
  const Index count = to_index(motion.courses.size()), loops = to_index(motion.loops.size());
  found.by_deflection.resize(count);
  found.by_rate.resize(count);
  found.by_travel.resize(loops);
  found.by_start.resize(loops);
  numerics::set_fourier_row(motion.harmonics, phase, found.row);
  for (Index j = 0; j < count; ++j) {
    const LawAbout::Force here = motion.courses[to_size(j)].at(found.row);
    found.by_deflection(j) = here.by_deviation;
    found.by_rate(j) = here.by_rate;
  }
  found.distances.clear();
  for (const Motion::Distance& one : motion.distances)
    found.distances.push_back(one.law->at_phase(one.course, motion.omega, phase));
  const auto on_loop = [&](const Motion::Loop& one) {
    return one.loop->at(one.loop->branch_at(phase), motion.courses[to_size(one.deflection)].deflection_at(phase));
  };
  for (const Motion::Loop& one : motion.sticking) found.by_deflection(one.deflection) += on_loop(one).by_travel;
  found.bristles.clear();
  for (const Motion::Bristles& one : motion.bristles) found.bristles.push_back(one.loop->at(phase));
  found.rubbings.clear();
  for (const Motion::Rubbing& one : motion.rubbings) {
    found.by_deflection.segment<2>(one.across).array() -= one.loop.law().own_stiffness();
    if (one.remembers()) found.rubbings.push_back(one.loop.moment(phase));
    else found.rubbings.push_back({});
    const bool sticks = one.loop.always_sticks() || found.rubbings.back().state == RubbingLoop::State::sticks;
    if (sticks) found.by_deflection.segment<2>(one.across).array() += one.loop.law().law().stiffness;
  }
  for (const Motion::Bristles& one : motion.stuck) {
    found.by_deflection(one.deflection) += one.loop->law().stiffness;
    found.by_rate(one.deflection) += one.loop->law().damping + one.loop->law().viscous;
  }
  for (Index h = 0; h < loops; ++h) {
    const elements::ForceOnTravel here = on_loop(motion.loops[to_size(h)]);
    found.by_travel(h) = here.by_travel;
    found.by_start(h) = here.by_start;
  }
}

MatrixXd PeriodicStability::with_constant_tangents(const Motion& motion, double from, double to) const {
  Tangents tangent;
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

/// What the laws answer in the middle of each step: forces, times the step, and below them the changes of bristles, by
/// the values of all deflections, their rates if there are dampers, and the memory of loops and bristles.
numerics::RowMatrix PeriodicStability::answers(const Motion& motion, double from, double to, int steps) const {
  if (motion.is_elastic()) return elastic_answers(motion, from, to, steps);
  const Index m = force_.cols(), loops = to_index(motion.loops.size()), bristles = to_index(motion.bristles.size()),
              rubbings = to_index(motion.rubbings.size()), carried = motion.carried();
  const double phase_step = (to - from) / steps, step = phase_step / motion.omega;
  const bool damped = motion.is_damped();
  const Index first_memory = damped ? 2 * m : m, first_rubbings = first_memory + 2 * loops,
              first_carried = first_memory + motion.kept();
  const MatrixXd rates_by_force = rates_ * force_;
  numerics::RowMatrix all((m + carried) * steps, first_memory + motion.memories());
  // Bristles are multiplied by the frequency at which they hold their mass: the transition then has entries of one
  // size, and its error is not that of stiff bristles alone.
  VectorXd scale = VectorXd::Ones(bristles);
  for (Index b = 0; b < bristles; ++b) {
    const Motion::Bristles& one = motion.bristles[to_size(b)];
    if (const double squared = one.loop->law().stiffness * std::abs(accelerations_(one.deflection)); squared > 0)
      scale(b) = std::sqrt(squared);
  }
  const VectorXd units = units_of_friction(motion);
  Tangents tangent;
  MatrixXd forces(m, all.cols()), sources(rubbings, all.cols());
  for (int i = 0; i < steps; ++i) {
    set_tangents(motion, from + (i + 0.5) * phase_step, tangent);
    forces.setZero();
    forces.leftCols(m).diagonal() = tangent.by_deflection;
    if (damped) forces.middleCols(m, m).diagonal() = tangent.by_rate;
    for (std::size_t d = 0; d < motion.distances.size(); ++d) {
      const Index first = motion.distances[d].first;
      forces.block<3, 3>(first, first) += tangent.distances[d].by_deflection;
      if (damped) forces.block<3, 3>(first, m + first) += tangent.distances[d].by_rate;
    }
    for (Index h = 0; h < loops; ++h) {
      const Index j = motion.loops[to_size(h)].deflection;
      forces(j, j) += tangent.by_travel(h);
      forces(j, first_memory + 2 * h) = -tangent.by_travel(h);
      forces(j, first_memory + 2 * h + 1) = tangent.by_start(h);
    }
    std::vector<BristleKick> of_bristles;
    for (Index b = 0; b < bristles; ++b) {
      const Index j = motion.bristles[to_size(b)].deflection;
      of_bristles.emplace_back(tangent.bristles[to_size(b)], step);
      forces(j, m + j) += of_bristles.back().by_rate;
      forces(j, first_carried + b) = of_bristles.back().by_start / scale(b);
    }
    sources.setZero();
    std::vector<Fading> of_rubbings;
    for (Index r = 0; r < rubbings; ++r) {
      const Motion::Rubbing& one = motion.rubbings[to_size(r)];
      const RubbingLoop::Moment& there = tangent.rubbings[to_size(r)];
      of_rubbings.emplace_back(there.fading * motion.omega, step);
      if (there.state == RubbingLoop::State::sticks)
        for (Index a = 0; a < 2; ++a) forces(one.across + a, first_rubbings + 2 * r + a) = units(r);
      if (there.state != RubbingLoop::State::slips) continue;
      const Eigen::Vector2d aside(-there.direction.y(), there.direction.x());
      auto source = sources.row(r);
      source.segment<2>(m + one.across) = one.loop.law().law().stiffness * aside.transpose();
      source(one.along) -= there.turning * motion.omega * there.limit.by_deflection;
      source(m + one.along) -= there.turning * motion.omega * there.limit.by_rate;
      for (Index a = 0; a < 2; ++a) {
        auto force = forces.row(one.across + a);
        force(one.along) += there.direction(a) * there.limit.by_deflection;
        force(m + one.along) += there.direction(a) * there.limit.by_rate;
        force += aside(a) * of_rubbings.back().mean_of_integral * step * source;
        force(first_carried + bristles + r) += aside(a) * of_rubbings.back().mean * units(r);
      }
    }
    if (damped) {  // implicit midpoint rule: the kick changes the rates that it depends on
      const MatrixXd left = MatrixXd::Identity(m, m) - step / 2 * (forces.middleCols(m, m) * rates_by_force);
      forces = numerics::PivotedLu<double>(left).solve(forces);
    }
    const Index first = i * (m + carried);
    all.middleRows(first, m) = step * forces;
    for (Index b = 0; b < bristles; ++b) {
      const Index j = motion.bristles[to_size(b)].deflection;
      auto change = all.row(first + m + b);
      const double grown = scale(b) * of_bristles[to_size(b)].grown;
      change = grown * step / 2 * rates_by_force.row(j) * forces;
      change(m + j) += grown;
      change(first_carried + b) += of_bristles[to_size(b)].kept - 1;
    }
    for (Index r = 0; r < rubbings; ++r) {
      const Fading& fading = of_rubbings[to_size(r)];
      auto change = all.row(first + m + bristles + r);
      change = sources.row(r) + sources.row(r).segment(m, m) * (step / 2 * rates_by_force * forces);
      change *= fading.mean * step / units(r);
      change(first_carried + bristles + r) += fading.kept - 1;
    }
  }
  return all;
}

/// One unit of a memory of a rubbing contact: the spring's force over the travel for which its frequency alone with the
/// mass is the rate, so that all states have one size.
VectorXd PeriodicStability::units_of_friction(const Motion& motion) const {
  VectorXd units(to_index(motion.rubbings.size()));
  for (std::size_t r = 0; r < motion.rubbings.size(); ++r) {
    const double k = motion.rubbings[r].loop.law().law().stiffness,
                 squared = k * std::abs(accelerations_(motion.rubbings[r].across));
    units(to_index(r)) = squared > 0 ? k / std::sqrt(squared) : k;
  }
  return units;
}

/// The same without dampers and memory.
numerics::RowMatrix PeriodicStability::elastic_answers(const Motion& motion, double from, double to, int steps) const {
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

MatrixXd PeriodicStability::split(const Motion& motion, double from, double to, int steps) const {
  const double step = (to - from) / steps / motion.omega;
  const Index n = F_.rows(), m = force_.cols(), memory = motion.memories(), all = n + memory,
              carried = motion.carried(), rates = motion.is_damped() ? m : 0;
  const bool in_modes = flow_.is_diagonalizable();
  numerics::LinearFlow::Kicks kicks{numerics::RowMatrix::Zero(all, m + carried),
                                    numerics::RowMatrix::Zero(m + rates + memory, all),
                                    answers(motion, from, to, steps)};
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

MatrixXd PeriodicStability::split(const Motion& motion, double from, double to, double accurate) const {
  constexpr int per_period = 16, most = 2048;
  // The coarsest steps turn the mass that a law holds by its tangent alone by about a fifth of its period.
  Tangents middle;
  set_tangents(motion, (from + to) / 2, middle);
  VectorXd stiffness = middle.by_deflection;
  for (std::size_t h = 0; h < motion.loops.size(); ++h)
    stiffness(motion.loops[h].deflection) += middle.by_travel(to_index(h));
  for (std::size_t b = 0; b < motion.bristles.size(); ++b)
    stiffness(motion.bristles[b].deflection) += middle.bristles[b].by_bristle * middle.bristles[b].gain;
  const double squared = stiffness.cwiseProduct(accelerations_).cwiseAbs().maxCoeff(),
               turned = std::sqrt(squared) * (to - from) / motion.omega;
  constexpr double turned_in_step = 1.2;
  const int fewest = std::max({2, static_cast<int>(std::ceil(per_period * (to - from) / two_pi)),
                               static_cast<int>(std::ceil(std::min(turned / turned_in_step, most / 8.0)))});
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
      if (last > 0 && ((row[last] - row[last - 1]).norm() <= accurate * row[last].norm() || count > most))
        return row.back();
    }
  }
}

/// At a turning point the memory of a loop becomes its deflection and force there.
void PeriodicStability::turn(const Motion& motion, std::size_t loop, double phase, MatrixXd& states) const {
  const Index n = F_.rows(), row = n + 2 * to_index(loop);
  const Motion::Loop& one = motion.loops[loop];
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
void PeriodicStability::jump(const Motion& motion, std::size_t loop, double phase, MatrixXd& states) const {
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

/// Where a rubbing contact begins to stick, to slip or to open, the variation of its force is the same on both sides.
void PeriodicStability::change_rubbing(const Motion& motion, std::size_t rubbing, double phase,
                                       MatrixXd& states) const {
  constexpr double beside = 1e-9;
  const Motion::Rubbing& one = motion.rubbings[rubbing];
  if (!one.remembers()) return;
  const RubbingLoop::Moment before = one.loop.moment(phase - beside), after = one.loop.moment(phase + beside);
  if (before.state == after.state) return;
  const Index n = F_.rows(), kept = n + 2 * to_index(motion.loops.size()) + 2 * to_index(rubbing),
              carried = n + motion.kept() + to_index(motion.bristles.size()) + to_index(rubbing);
  const double k = one.loop.law().law().stiffness, unit = units_of_friction(motion)(to_index(rubbing));
  const MatrixXd across = values_.middleRows(one.across, 2) * states.topRows(n);
  MatrixXd force = MatrixXd::Zero(2, states.cols());
  if (before.state == RubbingLoop::State::sticks) force = unit * states.middleRows(kept, 2) + k * across;
  if (before.state == RubbingLoop::State::slips) {
    const Eigen::Vector2d aside(-before.direction.y(), before.direction.x());
    const Eigen::RowVectorXd limit =
        (before.limit.by_deflection * values_.row(one.along) + before.limit.by_rate * rates_.row(one.along)) *
        states.topRows(n);
    force = before.direction * limit + unit * aside * states.row(carried);
  }
  states.middleRows(kept, 2).setZero();
  states.row(carried).setZero();
  if (after.state == RubbingLoop::State::sticks) states.middleRows(kept, 2) = (force - k * across) / unit;
  if (after.state == RubbingLoop::State::slips) {
    const Eigen::Vector2d aside(-after.direction.y(), after.direction.x());
    states.row(carried) = aside.transpose() * force / unit;
  }
}

Eigen::VectorXcd PeriodicStability::multipliers(const MachineLaws& laws, const VectorXd& deflections, double omega,
                                                double accurate) const {
  const Motion motion(laws, deflections, omega);
  std::vector<double> corners = {0, two_pi};
  for (const LawCourse& course : motion.courses)
    for (const double phase : course.all_corners()) corners.push_back(phase);
  for (const Motion::Distance& one : motion.distances)
    for (const double phase : one.law->corners(one.course)) corners.push_back(phase);
  for (const Motion::Rubbing& one : motion.rubbings)
    for (const double phase : one.loop.corners()) corners.push_back(phase);
  std::sort(corners.begin(), corners.end());
  const Index all = F_.rows() + motion.memories();
  MatrixXd period = MatrixXd::Identity(all, all);
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
    const MatrixXd piece =
        motion.is_piecewise_linear ? with_constant_tangents(motion, from, to) : split(motion, from, to, accurate);
    period = (piece * period).eval();
  }
  return numerics::general_eigenvalues(period).values;
}

}  // namespace trivet::nonlinear
