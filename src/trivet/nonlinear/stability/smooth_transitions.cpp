// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/laws/periodic_laws.h"
#include "trivet/nonlinear/stability/periodic_stability.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/matrix_exponential.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/gauss_nodes.h"
#include "trivet/response/transient/exponential_step.h"

/// State transitions over pieces in which the tangents change.
namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;

/// Rows of the Fourier basis in the middle of each step; those of whole periods are kept.
const MatrixXd& PeriodicStability::rows_in_steps(const PeriodicLaws& motion, double from, double to, int steps,
                                                 MatrixXd& of_piece) const {
  const bool whole = from == 0 && to == two_pi;
  constexpr std::size_t most_kept = 32;
  if (rows_.size() > most_kept) rows_.clear();
  MatrixXd& rows = whole ? rows_[{steps, motion.harmonics}] : of_piece;
  if (rows.size() > 0) return rows;
  rows.resize(steps, numerics::coefficient_count(motion.harmonics));
  for (int i = 0; i < steps; ++i)
    rows.row(i) = numerics::fourier_row(motion.harmonics, from + (i + 0.5) * (to - from) / steps);
  return rows;
}

/// `law_jacobians` without dampers and memory.
numerics::RowMatrix PeriodicStability::elastic_jacobians(const PeriodicLaws& motion, double from, double to,
                                                         int steps) const {
  const double step = (to - from) / steps / motion.omega;
  MatrixXd of_piece;
  const MatrixXd& rows = rows_in_steps(motion, from, to, steps, of_piece);
  const Index m = force_.cols();
  numerics::RowMatrix all = numerics::RowMatrix::Zero(m * steps, m);
  for (Index j = 0; j < m; ++j) {
    const VectorXd tangents = step * motion.courses[j].elastic_tangents(rows);
    for (int i = 0; i < steps; ++i) all(i * m + j, j) = tangents(i);
  }
  return all;
}

/// Highest frequency of the linear machine among the modes that the tangents turn by more than a share of a radian in a
/// time: kicks at intervals of half its period would feed it.
/// @param largest  sizes of the tangents, deflections × deflections
double PeriodicStability::fastest_kicked(const MatrixXd& largest, double time) const {
  constexpr double noticed = 0.3;
  double fastest = 0;
  if (!flow_.is_diagonalizable()) return fastest;
  for (Index p = 0; p < F_.rows(); ++p)
    if (const double turning = flow_.turning()(p);
        turning > fastest && kicked_.row(p).dot(largest * moved_.col(p)) * time > noticed)
      fastest = turning;
  return fastest;
}

/// The highest frequency that the tangents bring about, at sampled phases, or half of the highest rate of decay
/// [rad/s].
double PeriodicStability::fastest(const PeriodicLaws& motion, double from, double to) const {
  constexpr int per_period = 16;
  const double share = (to - from) / two_pi, time = (to - from) / motion.omega;
  const int samples = std::max(
      2, static_cast<int>(std::ceil(share * static_cast<double>(std::max<Index>(per_period, motion.harmonics)))));
  const Index m = force_.cols();
  if (motion.is_elastic() && !deflection_response_.massless && motion.bristles.empty()) {
    MatrixXd of_piece;
    const MatrixXd& rows = rows_in_steps(motion, from, to, samples, of_piece);
    MatrixXd tangents(m, samples);
    for (Index j = 0; j < m; ++j) tangents.row(j) = motion.courses[j].elastic_tangents(rows).cwiseAbs().transpose();
    const VectorXd largest = tangents.rowwise().maxCoeff();
    return std::max(std::sqrt((alike_.cwiseAbs() * tangents).maxCoeff()),
                    fastest_kicked(MatrixXd(largest.asDiagonal()), time));
  }
  double fastest = 0;
  TangentsAlong tangent;
  MatrixXd largest_stiffness = MatrixXd::Zero(m, m);
  const auto largest = [](const MatrixXd& matrix) { return matrix.cwiseAbs().rowwise().sum().maxCoeff(); };
  const VectorXd size = accelerations_.cwiseAbs().cwiseSqrt().unaryExpr([](double one) { return one > 0 ? one : 1.0; });
  const auto in_alike_units = [&](const MatrixXd& matrix) -> MatrixXd {
    return size.asDiagonal() * matrix * size.cwiseInverse().asDiagonal();
  };
  for (int i = 0; i < samples; ++i) {
    set_tangents(motion, from + (i + 0.5) * (to - from) / samples, tangent);
    MatrixXd stiffness = tangent.stiffness(motion), damping = tangent.damping(motion);
    for (std::size_t b = 0; b < motion.bristles.size(); ++b) {
      const Index j = motion.bristles[b].deflection;
      stiffness(j, j) += tangent.bristles[b].by_bristle * tangent.bristles[b].gain;
    }
    if (deflection_response_.massless) {
      const numerics::PivotedLu<double> left(deflection_response_.left_side(stiffness, damping, 0));
      stiffness = left.solve(stiffness);
      damping = left.solve(damping);
      fastest = std::max(fastest, largest(deflection_response_.drifts * stiffness) / 2);
    }
    largest_stiffness = largest_stiffness.cwiseMax(stiffness.cwiseAbs());
    fastest = std::max({fastest, std::sqrt(largest(alike_ * in_alike_units(stiffness))),
                        largest(alike_ * in_alike_units(damping)) / 2});
  }
  return std::max(fastest, fastest_kicked(largest_stiffness, time));
}

/// ∫ of the trace of ẋ = F(t) x by time, of laws without memory: of the linear machine, and of those that depend on
/// rates or act on nodes.
double PeriodicStability::trace(const PeriodicLaws& motion, double from, double to) const {
  const double of_machine = F_.trace() * (to - from) / motion.omega;
  if (!deflection_response_.massless && !motion.is_damped()) return of_machine;
  TangentsAlong tangent;
  const auto of_laws = [&](double phase) {
    set_tangents(motion, phase, tangent);
    const MatrixXd damping = tangent.damping(motion);
    if (deflection_response_.massless) {
      const MatrixXd stiffness = tangent.stiffness(motion),
                     rates = stiffness * deflection_response_.drifts + damping * deflection_response_.rates;
      return numerics::PivotedLu<double>(deflection_response_.left_side(stiffness, damping, 0)).solve(rates).trace();
    }
    return damping.cwiseProduct(deflection_response_.rates.transpose()).sum();
  };
  if (motion.is_piecewise_linear) return of_machine + of_laws((from + to) / 2) * (to - from) / motion.omega;
  constexpr double longest = two_pi / 4;
  double sum = 0;
  numerics::each_gauss_node(from, to, longest, [&](double phase, double weight) { sum += weight * of_laws(phase); });
  return of_machine + sum / motion.omega;
}

MatrixXd PeriodicStability::split(const PeriodicLaws& motion, double from, double to, int steps) const {
  const double step = (to - from) / steps / motion.omega;
  const Index n = F_.rows(), m = force_.cols(), memory = motion.memories(), all = n + memory,
              carried = motion.carried(), rates = motion.is_damped() ? m : 0;
  const bool in_modes = flow_.is_diagonalizable();
  numerics::LinearFlow::Kicks kicks{numerics::RowMatrix::Zero(all, m + carried),
                                    numerics::RowMatrix::Zero(m + rates + memory, all),
                                    motion.is_elastic() && !deflection_response_.massless
                                        ? elastic_jacobians(motion, from, to, steps)
                                        : law_jacobians(motion, deflection_response_, from, to, steps)};
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
    y += (kicks.kick * (kicks.jacobians.middleRows(i * (m + carried), m + carried) * (kicks.seen * y))).eval();
    y.topRows(n) = (half * y.topRows(n)).eval();
  }
  return y;
}

PeriodicStability::Transition PeriodicStability::split(const PeriodicLaws& motion, double from, double to, int fewest,
                                                       double accurate) const {
  constexpr int least_limit = 2048, of_fewest = 3;
  const int most = std::max(least_limit, of_fewest * fewest);
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

/// F(t) of the states and memories at a phase: the Jacobian of the laws in a step of almost no length.
MatrixXd PeriodicStability::rates_of_states(const PeriodicLaws& motion, double phase) const {
  constexpr double almost_none = 1e-10;  // of a radian
  const Index n = F_.rows(), m = force_.cols(), memory = motion.memories(), all = n + memory,
              carried = motion.carried(), rates = motion.is_damped() ? m : 0;
  const numerics::RowMatrix jacobians =
      law_jacobians(motion, deflection_response_, phase - almost_none / 2, phase + almost_none / 2, 1) *
      (motion.omega / almost_none);
  MatrixXd kick = MatrixXd::Zero(all, m + carried), seen = MatrixXd::Zero(m + rates + memory, all);
  kick.topLeftCorner(n, m) = force_;
  kick.bottomRightCorner(carried, carried).setIdentity();
  seen.topLeftCorner(m, n) = values_;
  if (rates > 0) seen.block(m, 0, m, n) = rates_;
  seen.bottomRightCorner(memory, memory).setIdentity();
  MatrixXd F = kick * (jacobians * seen);
  F.topLeftCorner(n, n) += F_;
  return F;
}

/// Two exponentials a step, of the tangents at Gauss's two places.
MatrixXd PeriodicStability::exponentials(const PeriodicLaws& motion, double from, double to, int steps) const {
  const double third = std::sqrt(3.0), near = 0.25 + third / 6, far = 0.25 - third / 6, place = third / 6,
               length = (to - from) / steps, step = length / motion.omega;
  const Index all = F_.rows() + motion.memories();
  MatrixXd y = MatrixXd::Identity(all, all);
  for (int i = 0; i < steps; ++i) {
    const double middle = from + (i + 0.5) * length;
    const MatrixXd first = rates_of_states(motion, middle - place * length),
                   second = rates_of_states(motion, middle + place * length);
    y = (numerics::matrix_exponential(step * (near * first + far * second)) * y).eval();
    y = (numerics::matrix_exponential(step * (far * first + near * second)) * y).eval();
  }
  return y;
}

/// The same by Radau IIA: directions that decay within a step are at zero after it.
MatrixXd PeriodicStability::collocated(const PeriodicLaws& motion, double from, double to, int steps) const {
  const double r = std::sqrt(6.0), length = (to - from) / steps, step = length / motion.omega;
  const std::array<double, 3> places = {(4 - r) / 10, (4 + r) / 10, 1};
  const std::array<std::array<double, 3>, 3> weights = {
      {{(88 - 7 * r) / 360, (296 - 169 * r) / 1800, (-2 + 3 * r) / 225},
       {(296 + 169 * r) / 1800, (88 + 7 * r) / 360, (-2 - 3 * r) / 225},
       {(16 - r) / 36, (16 + r) / 36, 1.0 / 9}}};
  const Index all = F_.rows() + motion.memories();
  MatrixXd y = MatrixXd::Identity(all, all), left(3 * all, 3 * all), right(3 * all, all);
  for (int i = 0; i < steps; ++i) {
    left.setIdentity();
    for (std::size_t j = 0; j < 3; ++j) {
      constexpr double within = 1e-9;  // not beyond a corner at the end
      const MatrixXd F = rates_of_states(motion, from + (i + places[j] - within) * length);
      for (std::size_t k = 0; k < 3; ++k)
        left.block(to_index(k) * all, to_index(j) * all, all, all) -= step * weights[k][j] * F;
      right.middleRows(to_index(j) * all, all) = y;
    }
    y = numerics::PivotedLu<double>(left).solve(right).bottomRows(all);
  }
  return y;
}

/// Do all directions decay that are too quick for steps of a period?
bool PeriodicStability::is_overdamped(const PeriodicLaws& motion, double from, double to) const {
  constexpr double quick = 300, decays = 0.2;
  const numerics::GeneralEigen found = numerics::general_eigenvalues(rates_of_states(motion, (from + to) / 2));
  const double time = two_pi / motion.omega;
  return found.converged && std::ranges::all_of(found.values, [&](const std::complex<double>& one) {
           return std::abs(one) * time < quick || one.real() < -decays * std::abs(one);
         });
}

PeriodicStability::Transition PeriodicStability::stiff(const PeriodicLaws& motion, double from, double to,
                                                       double accurate) const {
  constexpr int per_period = 32, most = 512;
  const bool implicit = is_overdamped(motion, from, to);
  const double improved = implicit ? 31 : 15;  // 2^order − 1
  const auto over = [&](int steps) {
    return implicit ? collocated(motion, from, to, steps) : exponentials(motion, from, to, steps);
  };
  int steps = std::max(2, static_cast<int>(std::ceil(per_period * (to - from) / two_pi)));
  MatrixXd before = over(steps);
  for (;;) {
    steps *= 2;
    MatrixXd now = over(steps);
    const double change = (now - before).norm() / improved, size = now.norm();
    if (change <= accurate * size) return {now};
    if (steps >= most || !std::isfinite(size)) return {now, std::isfinite(size) ? change / size : foundation::infinity};
    before = std::move(now);
  }
}

PeriodicStability::Transition PeriodicStability::smooth(const PeriodicLaws& motion, double from, double to,
                                                        double accurate) const {
  constexpr int per_period = 16, usual = 256, most = 2048;
  // The coarsest steps turn the mass that a law holds by its tangent alone by about a fifth of its period in the
  // middle, and nowhere by so much that they grow by themselves, which begins at 2.
  constexpr double turned_in_step = 1.2, bears = 1.8;
  TangentsAlong middle;
  set_tangents(motion, (from + to) / 2, middle);
  VectorXd stiffness = middle.by_deflection;
  for (std::size_t h = 0; h < motion.loops.size(); ++h)
    stiffness(motion.loops[h].deflection) += middle.by_travel(to_index(h));
  for (std::size_t b = 0; b < motion.bristles.size(); ++b)
    stiffness(motion.bristles[b].deflection) += middle.bristles[b].by_bristle * middle.bristles[b].gain;
  for (std::size_t r = 0; r < motion.rubbings.size(); ++r)
    stiffness(motion.rubbings[r].on) += middle.rubbings[r].by_deflection.diagonal();
  const double time = (to - from) / motion.omega,
               turned = std::sqrt(stiffness.cwiseProduct(accelerations_).cwiseAbs().maxCoeff()) * time;
  const double needed = std::ceil(fastest(motion, from, to) * time / bears);
  constexpr double trusted = 1e-5;
  Transition found{MatrixXd(), foundation::infinity};
  if (needed <= most) {
    const int fewest = std::max({2, static_cast<int>(std::ceil(per_period * (to - from) / two_pi)),
                                 static_cast<int>(std::ceil(std::min<double>(usual, turned / turned_in_step))),
                                 static_cast<int>(needed)});
    found = split(motion, from, to, fewest, accurate);
    if (found.uncertainty <= trusted) return found;
  }
  Transition other = stiff(motion, from, to, accurate);
  return found.states.size() == 0 || other.uncertainty < found.uncertainty ? other : found;
}

}  // namespace trivet::nonlinear
