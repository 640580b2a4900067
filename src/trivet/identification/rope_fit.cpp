// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/rope_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/identification/levenberg_marquardt.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using foundation::two_pi;

constexpr double highest_exponent = 9;
constexpr Index samples = 240;  // a turning point between two samples is missed by 4e-5 of the travel

VectorXd motion_of(const LoopFit& loop) {
  VectorXd motion = VectorXd::Zero(samples);
  for (Index i = 0; i < samples; ++i)
    for (Index n = 0; n < loop.displacement_harmonics.size(); ++n)
      motion(i) += (loop.displacement_harmonics(n) *
                    std::polar(1.0, two_pi * static_cast<double>((n + 1) * i) / static_cast<double>(samples)))
                       .real();
  return motion;
}

/// z of a Bouc–Wen force of limit 1 along a motion, after its loop has closed.
VectorXd friction_along(const VectorXd& motion, double deflection, double exponent) {
  const elements::BoucWen law{.stiffness = 1 / deflection, .force = 1, .exponent = exponent};
  VectorXd force(samples);
  double turn = motion(0), at_turn = 0, last = 0, direction = 0;
  constexpr int periods = 12;  // small loops are almost elastic, and close slowly
  constexpr double closed = 1e-7;
  for (int period = 0; period < periods; ++period) {
    const double before_period = last;
    for (Index i = 0; i < samples; ++i) {
      const double before = motion((i + samples - 1) % samples), now = motion(i), sense = now < before ? -1 : 1;
      if (direction != 0 && sense != direction) {
        turn = before;
        at_turn = last;
      }
      direction = sense;
      last = elements::force_on_travel(law, at_turn, now - turn).force;
      force(i) = last;
    }
    if (period > 0 && std::abs(last - before_period) < closed) break;
  }
  return force;
}

/// Real and imaginary parts of the first harmonics, divided by a scale.
VectorXd harmonics_of(const VectorXd& signal, Index count, double scale) {
  VectorXd found = VectorXd::Zero(2 * count);
  for (Index n = 1; n <= count; ++n)
    for (Index i = 0; i < samples; ++i) {
      const std::complex<double> wave =
          std::polar(2.0 / static_cast<double>(samples),
                     -two_pi * static_cast<double>(n * i) / static_cast<double>(samples)) *
          signal(i) / scale;
      found(2 * n - 2) += wave.real();
      found(2 * n - 1) += wave.imag();
    }
  return found;
}

/// The best linear parameters k, a, c, F of one deflection F/k and exponent.
class RopeModel {
 public:
  explicit RopeModel(const std::vector<LoopFit>& loops) {
    for (const LoopFit& loop : loops) {
      motions_.push_back(motion_of(loop));
      largest_ = std::max(largest_, motions_.back().cwiseAbs().maxCoeff());
      counts_.push_back(loop.force_harmonics.size());
      scales_.push_back(std::abs(loop.force_harmonics(0)));
      for (Index n = 0; n < counts_.back(); ++n) {
        const std::complex<double> one = loop.force_harmonics(n) / scales_.back();
        measured_.conservativeResize(measured_.size() + 2);
        measured_.tail<2>() << one.real(), one.imag();
      }
    }
  }

  /// Logarithms of the deflection over the largest one, and of the exponent less 1.
  [[nodiscard]] double deflection(const VectorXd& p) const { return largest_ * std::exp(p(0)); }
  [[nodiscard]] static double exponent(const VectorXd& p) { return 1 + std::min(std::exp(p(1)), highest_exponent - 1); }

  struct Solution {
    VectorXd parameters, residuals;
  };
  [[nodiscard]] Solution solved(const VectorXd& p) const {
    MatrixXd columns(measured_.size(), 4);
    Index row = 0;
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      const VectorXd &x = motions_[i], scaled = x / largest_;
      const Index count = counts_[i];
      const auto set = [&](Index column, const VectorXd& signal) {
        columns.block(row, column, 2 * count, 1) = harmonics_of(signal, count, scales_[i]);
      };
      set(0, scaled);
      set(1, scaled.cwiseAbs2());
      set(2, scaled.array().cube().matrix());
      set(3, friction_along(x, deflection(p), exponent(p)));
      row += 2 * count;
    }
    const VectorXd size = columns.colwise().norm();
    const MatrixXd unit = columns * size.cwiseInverse().asDiagonal();
    VectorXd found =
        numerics::PivotedLu<double>(MatrixXd(unit.transpose() * unit)).solve(VectorXd(unit.transpose() * measured_));
    VectorXd residuals = unit * found - measured_;
    found = found.cwiseQuotient(size);
    return {std::move(found), std::move(residuals)};
  }

  [[nodiscard]] RopeFit fit(const VectorXd& p) const {
    const Solution best = solved(p);
    RopeFit found;
    found.stiffness = best.parameters(0) / largest_;
    found.quadratic = best.parameters(1) / (largest_ * largest_);
    found.cubic = best.parameters(2) / std::pow(largest_, 3);
    found.friction = {
        .stiffness = best.parameters(3) / deflection(p), .force = best.parameters(3), .exponent = exponent(p)};
    Index row = 0;
    for (const Index count : counts_) {
      found.rms.push_back(best.residuals.segment(row, 2 * count).norm());
      row += 2 * count;
    }
    found.relative_rms = best.residuals.norm() / std::sqrt(static_cast<double>(counts_.size()));
    return found;
  }

 private:
  std::vector<VectorXd> motions_;
  std::vector<Index> counts_;
  std::vector<double> scales_;
  VectorXd measured_;
  double largest_ = 0;
};

}  // namespace

foundation::Expected<RopeFit> rope_fit(const std::vector<LoopFit>& loops) {
  foundation::Problems problems;
  double smallest = 0, largest = 0;
  for (const LoopFit& loop : loops) {
    largest = std::max(largest, loop.amplitude.value);
    smallest = smallest == 0 ? loop.amplitude.value : std::min(smallest, loop.amplitude.value);
  }
  constexpr double apart = 2;
  if (loops.size() < 2 || largest < apart * smallest) {
    problems.error("", fmt::format("{} loops, amplitudes from {:.4g} to {:.4g}", loops.size(), smallest, largest),
                   "sticking and slip are distinguished by loops whose amplitudes differ by a factor of two at least",
                   "measure small and large loops");
    return tl::make_unexpected(std::move(problems));
  }
  for (const LoopFit& loop : loops)
    if (!(loop.force_harmonics.size() > 0 && std::abs(loop.force_harmonics(0)) > 0)) {
      problems.error("", "a loop without force", "each loop has a force of its frequency",
                     "remove it, or check its column");
      return tl::make_unexpected(std::move(problems));
    }
  const RopeModel model(loops);
  std::optional<LeastSquaresMinimum> best;
  for (const double start : {0.5, 0.15, 0.05}) {  // of the largest deflection
    LeastSquaresMinimum found = least_squares_minimum([&](const VectorXd& p) { return model.solved(p).residuals; },
                                                      VectorXd{{std::log(start), std::log(0.5)}});
    if (found.converged && (!best || found.residuals.norm() < best->residuals.norm())) best = std::move(found);
  }
  const std::optional<RopeFit> fit = best ? std::optional(model.fit(best->parameters)) : std::nullopt;
  constexpr double at_bound = 0.99;
  std::string found_instead;
  if (!fit) found_instead = "the search did not converge";
  else if (!(fit->friction.force > 0))
    found_instead = "a friction of " + foundation::prefixed(fit->friction.force, "N") + " fits best";
  else if (!(fit->stiffness >= 0))
    found_instead = "a spring of " + foundation::prefixed(fit->stiffness, "N/m") + " fits best";
  else if (fit->friction.exponent > at_bound * highest_exponent)
    found_instead = fmt::format("an exponent above {:g} fits best", at_bound * highest_exponent);
  if (!found_instead.empty()) {
    problems.error(
        "", found_instead, "slow loops are those of a spring with dry friction, which lose energy",
        "measure loops large enough to slip, check the sense and the units of both columns, or give numbers");
    return tl::make_unexpected(std::move(problems));
  }
  return *fit;
}

}  // namespace trivet::identification
