// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/balance/phase_equations.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

PhaseEquations::PhaseEquations(const ReferenceMachine& machine, Index harmonics, const HeldPhase& held, double load)
    : held_(held),
      balance_(machine.condensed, machine.deflections, harmonics),
      cosine_(machine.condensed.basis().place(held.deflection) * balance_.coefficients() + 2 * held.harmonic - 1),
      branch_([this](const VectorXd& u, double factor, numerics::Equations& e) { evaluate(u, factor, e); }, load,
              [this](const VectorXd& u) { return scale(u); }) {}

Driving PhaseEquations::driving(const BranchPoint& point) {
  return {std::exp(point.unknowns(point.unknowns.size() - 1)), point.parameter};
}

double PhaseEquations::lag_at(double omega) const { return held_.lag - held_.reference.phase_at(order() * omega); }

double PhaseEquations::phase_equation(const VectorXd& motion, double lag) const {
  assert(cosine_ > 0 && cosine_ + 1 < motion.size() && "the held harmonic is one of the unknowns");
  return motion(cosine_) * std::sin(lag) - motion(cosine_ + 1) * std::cos(lag);
}

double PhaseEquations::slope_of_phase_equation(const VectorXd& motion, double lag) const {
  return motion(cosine_) * std::cos(lag) + motion(cosine_ + 1) * std::sin(lag);
}

std::optional<double> PhaseEquations::linear_resonance(double load, double from, double to) const {
  constexpr int places = 4000, halvings = 60;
  const auto ahead = [&](double omega) { return phase_equation(balance_.linear_motion({omega, load}), lag_at(omega)); };
  double largest = 0, found = 0, before = from;
  for (int i = 1; i <= places; ++i) {
    const double omega = from * std::pow(to / from, static_cast<double>(i) / places);
    if ((ahead(before) < 0) != (ahead(omega) < 0)) {
      double low = before, high = omega;
      for (int h = 0; h < halvings; ++h)
        ((ahead(low) < 0) == (ahead((low + high) / 2) < 0) ? low : high) = (low + high) / 2;
      const VectorXd motion = balance_.linear_motion({low, load});
      const double size = std::hypot(motion(cosine_), motion(cosine_ + 1));
      // Not at the opposite phase.
      if (slope_of_phase_equation(motion, lag_at(low)) > 0 && size > largest) {
        largest = size;
        found = low;
      }
    }
    before = omega;
  }
  return found == 0 ? std::nullopt : std::optional(found);
}

std::optional<BranchPoint> PhaseEquations::near_linear(double omega, double load) const {
  VectorXd guess(balance_.size() + 1);
  guess << balance_.linear_motion({omega, load}), std::log(omega);
  return branch_.start(guess, load);
}

void PhaseEquations::evaluate(const VectorXd& unknowns, double load, numerics::Equations& equations) const {
  const Index n = balance_.size();
  const double omega = std::exp(unknowns(n));
  assert(unknowns.size() == n + 1 && "the last unknown is log ω");
  numerics::Equations over_frequency;
  balance_.evaluate(unknowns.head(n), {omega, load}, Parameter::frequency, over_frequency);
  equations.value.resize(n + 1);
  const double lag = lag_at(omega);
  equations.value << over_frequency.value, phase_equation(unknowns, lag);
  equations.by_unknowns.setZero(n + 1, n + 1);
  equations.by_unknowns.topLeftCorner(n, n) = over_frequency.by_unknowns;
  equations.by_unknowns.topRightCorner(n, 1) = omega * over_frequency.by_parameter;
  equations.by_unknowns(n, cosine_) = std::sin(lag);
  equations.by_unknowns(n, cosine_ + 1) = -std::cos(lag);
  equations.by_unknowns(n, n) = slope_of_phase_equation(unknowns, lag) * order() * omega * held_.reference.delay;
  equations.by_parameter.setZero(n + 1);
  equations.by_parameter.head(n) = -balance_.linear_motion({omega, 1});
}

VectorXd PhaseEquations::scale(const VectorXd& unknowns) const {
  constexpr double of_frequency = 0.1;
  const Index n = balance_.size();
  const VectorXd sizes = balance_.largest(unknowns.head(n)).cwiseMax(std::numeric_limits<double>::min());
  VectorXd found(n + 1);
  found << sizes.transpose().replicate(balance_.coefficients(), 1).reshaped(), of_frequency;
  return found;
}

}  // namespace trivet::nonlinear
