// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/known_forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::two_pi;

bool KnownForces::has_friction_without_spring() const {
  return std::any_of(deflections_.begin(), deflections_.end(), [](const Deflection& one) {
    return std::any_of(one.law.hysteretic().begin(), one.law.hysteretic().end(),
                       [](const LawAbout::Hysteretic& part) { return elements::jumps_at_turns(part.law); });
  });
}

std::string KnownForces::reason_unknown(const HarmonicBalance& balance, const VectorXd& motion, double omega) const {
  const Index C = balance.coefficients();
  constexpr double round_off = 1e-9;
  const double smallest = round_off * motion.cwiseAbs().maxCoeff();
  std::vector<std::vector<double>> turns(deflections_.size());
  for (std::size_t j = 0; j < deflections_.size(); ++j) {
    const Index first = to_index(j) * C;
    if (deflections_[j].distance)
      if (std::string reason = out_of_distances(j, motion.segment(first, 3 * C).reshaped(C, 3)); !reason.empty())
        return reason;
    if (std::string reason = out_of_curve(j, motion.segment(first, C)); !reason.empty()) return reason;
    if (std::string reason = rests(j, balance.laws().single()[j], motion.segment(first, C), smallest, omega, turns[j]);
        !reason.empty())
      return reason;
  }
  return turn_together(turns);
}

/// Of a curve that must not be extended.
std::string KnownForces::out_of_curve(std::size_t j, const VectorXd& motion) const {
  const auto [low, high] = deflections_[j].law.range();
  if (!std::isfinite(low) && !std::isfinite(high)) return "";
  const Index samples = 4 * motion.size();
  for (Index n = 0; n < samples; ++n) {
    const double phase = two_pi * static_cast<double>(n) / static_cast<double>(samples);
    const double deviation = numerics::motion_at((motion.size() - 1) / 2, phase, motion);
    if (deviation < low || deviation > high)
      return fmt::format("{} leaves its curve: {:.6g} from rest, known from {:.6g} to {:.6g}", deflections_[j].name,
                         deviation, low, high);
  }
  return "";
}

std::string KnownForces::out_of_distances(std::size_t j, const Eigen::MatrixXd& motion) const {
  const DistanceAbout& law = *deflections_[j].distance;
  const auto [low, high] = law.range();
  if (!std::isfinite(low) && !std::isfinite(high)) return "";
  const Index samples = 4 * motion.rows();
  for (Index n = 0; n < samples; ++n) {
    const double phase = two_pi * static_cast<double>(n) / static_cast<double>(samples);
    const Eigen::Vector3d here = (numerics::fourier_row((motion.rows() - 1) / 2, phase) * motion).transpose();
    if (const double distance = law.distance(here); distance < low || distance > high)
      return fmt::format("{} reaches a length of {:.6g} m; its forces are known from {:.6g} to {:.6g} m",
                         deflections_[j].name, distance, low, high);
  }
  return "";
}

/// Of friction without a spring: where its deflection turns, the force that would hold it there exceeds the static
/// limit, or it rests for a while, and its force is unknown. The motion of the harmonics has the acceleration without
/// friction there, the mean of those before and after. A deflection whose rate never becomes that of a turning point
/// rests too.
std::string KnownForces::rests(std::size_t j, const LawHarmonics& law, const VectorXd& motion, double smallest,
                               double omega, std::vector<double>& turns) const {
  double limit = 0;
  for (const LawAbout::Hysteretic& part : law.law().hysteretic())
    if (const auto* friction = std::get_if<elements::CoulombFriction>(&part.law)) limit += friction->limit();
  if (limit == 0 || motion.tail(motion.size() - 1).norm() <= smallest) return "";
  const VectorXd acceleration = omega * omega * numerics::phase_derivative(numerics::phase_derivative(motion));
  const LawCourse course = law.course(motion, omega);
  double least = std::numeric_limits<double>::infinity();  // that would hold it at a turning point
  for (const HystereticLoop& loop : course.loops())
    if (elements::jumps_at_turns(loop.law()))
      for (const HystereticLoop::Branch& branch : loop.branches()) {
        turns.push_back(branch.from);
        least = std::min(least,
                         std::abs(numerics::motion_at((motion.size() - 1) / 2, branch.from, acceleration)) /
                             law.law().acceleration_per_force());
      }
  if (turns.empty()) least = 0;
  return least > limit ? ""
                       : fmt::format(
                             "the friction of {} rests for a part of the period: {:.4g} would hold it where it "
                             "turns, and it holds up to {:.4g}; give it a stiffness, with which it can stick",
                             deflections_[j].name, least, limit);
}

/// Of two frictions that turn at one instant on one body: each changes the acceleration of both.
std::string KnownForces::turn_together(const std::vector<std::vector<double>>& turns) const {
  constexpr double together = 1e-3, coupled = 1e-6;
  for (std::size_t i = 0; i < turns.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (turns[i].empty() || turns[j].empty()) continue;
      const Deflection &one = deflections_[i], &other = deflections_[j];
      const double both = std::abs(one.accelerations.dot(other.on_coordinates)),
                   own = std::sqrt(one.law.acceleration_per_force() * other.law.acceleration_per_force());
      if (!(both > coupled * own)) continue;
      for (const double a : turns[i])
        for (const double b : turns[j])
          if (std::abs(std::remainder(a - b, two_pi)) < together)
            return fmt::format(
                "the frictions of {} and {} turn at the same instant, which is computed for one without a "
                "stiffness only; make them one friction, or give them a stiffness",
                other.name, one.name);
    }
  return "";
}

}  // namespace trivet::nonlinear
