// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/balance/force_domain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::two_pi;

/// Where friction without a spring turns.
struct ForceDomain::Turn {
  std::size_t deflection = 0;
  double phase = 0;
  double acceleration = 0;  ///< without friction there: the mean of those before and after, as of the harmonics
  double limit = 0;         ///< of the static friction
};

std::string ForceDomain::hint() const {
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(deflections_, [&](const Deflection& one) {
      return std::ranges::any_of(one.law.hysteretic(),
                                 [&](const DeviationLaw::Hysteretic& part) { return is(part.law); });
    });
  };
  if (any(elements::jumps_at_turns)) return "; friction without a stiffness may rest there: give it one";
  const bool weakens = std::ranges::any_of(deflections_, [](const Deflection& one) {
    return std::ranges::any_of(one.law.bristles(),
                               [](const DeviationLaw::Bristles& part) { return part.law.has_stribeck_effect(); });
  });
  if (weakens || any([](const elements::HystereticForce& law) { return elements::jump_at_kink(law, 1) != 0; }))
    return "; friction that breaks away above its slip moves in bursts at low frequencies: begin higher";
  return "";
}

std::string ForceDomain::reason_unknown(const HarmonicBalance& balance, const VectorXd& unknowns, double omega) const {
  const Eigen::MatrixXd motions = balance.motion(unknowns);
  std::vector<Turn> turns;
  for (std::size_t j = 0; j < deflections_.size(); ++j) {
    if (deflections_[j].distance)
      if (std::string reason = out_of_distances(j, motions.middleCols(to_index(j), 3)); !reason.empty()) return reason;
    if (std::string reason = out_of_curve(j, motions.col(to_index(j))); !reason.empty()) return reason;
    if (std::string reason = add_turns(j, balance.laws(), motions, omega, turns); !reason.empty()) return reason;
  }
  for (std::size_t i = 0; i < turns.size(); ++i)
    if (std::string reason = rests_at_turn(turns, i); !reason.empty()) return reason;
  return "";
}

/// Of a curve that must not be extended.
std::string ForceDomain::out_of_curve(std::size_t j, const VectorXd& motion) const {
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

std::string ForceDomain::out_of_distances(std::size_t j, const Eigen::MatrixXd& motion) const {
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

/// A deflection whose rate never becomes that of a turning point rests all the time.
std::string ForceDomain::add_turns(std::size_t j, const LawSet& laws, const Eigen::MatrixXd& motions, double omega,
                                   std::vector<Turn>& turns) const {
  constexpr double round_off = 1e-9;
  const double smallest = round_off * motions.cwiseAbs().maxCoeff();
  const VectorXd motion = motions.col(to_index(j));
  double limit = 0;
  for (const DeviationLaw::Hysteretic& part : laws.single()[j].law().hysteretic())
    if (const auto* friction = std::get_if<elements::CoulombFriction>(&part.law)) limit += friction->limit();
  if (limit == 0 || motion.tail(motion.size() - 1).norm() <= smallest) return "";
  const VectorXd acceleration = omega * omega * numerics::phase_derivative(numerics::phase_derivative(motion));
  const LawOverPeriod course = laws.course(to_index(j), motions, omega);
  const std::size_t before = turns.size();
  for (const HystereticLoop& loop : course.loops()) {
    if (!elements::jumps_at_turns(loop.law())) continue;
    for (const HystereticLoop::Branch& branch : loop.branches())
      turns.push_back({j, branch.from, numerics::motion_at((motion.size() - 1) / 2, branch.from, acceleration), limit});
    break;  // several on one deflection turn together
  }
  if (turns.size() > before) return "";
  return fmt::format(
      "the friction of {} rests: up to {:.4g} {} it does not move at all; give it a stiffness, with which it can "
      "stick, "
      "or begin where the excitation moves it",
      deflections_[j].name, limit, deflections_[j].is_rotation ? "N m" : "N");
}

/// At each turn the forces that would hold all frictions that turn there: one of them exceeds its static limit, or they
/// rest for a while. Where several turn on one body, the smallest such forces.
std::string ForceDomain::rests_at_turn(const std::vector<Turn>& turns, std::size_t at) const {
  constexpr double together = 1e-3, singular = 1e-9;
  std::vector<const Turn*> here;
  for (const Turn& turn : turns)
    if (std::abs(std::remainder(turn.phase - turns[at].phase, two_pi)) < together) here.push_back(&turn);
  const auto count = to_index(here.size());
  Eigen::MatrixXd per_force(count, count);
  VectorXd acceleration(count);
  for (Index i = 0; i < count; ++i) {
    acceleration(i) = here[i]->acceleration;
    for (Index k = 0; k < count; ++k)
      per_force(i, k) =
          deflections_[here[i]->deflection].accelerations.dot(deflections_[here[k]->deflection].on_coordinates);
  }
  per_force.diagonal() *= 1 + singular;
  const VectorXd holds = numerics::PivotedLu<double>(per_force).solve(acceleration);
  for (Index i = 0; i < count; ++i)
    if (std::abs(holds(i)) > here[i]->limit) return "";
  return fmt::format(
      "the friction of {} rests for a part of the period: {:.4g} {} would hold it where it turns, and it "
      "holds up to {:.4g}; give it a stiffness, with which it can stick",
      deflections_[here.front()->deflection].name, std::abs(holds(0)),
      deflections_[here.front()->deflection].is_rotation ? "N m" : "N", here.front()->limit);
}

}  // namespace trivet::nonlinear
