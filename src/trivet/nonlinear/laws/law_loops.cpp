// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_harmonics.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {
namespace {

using foundation::two_pi;

/// A deflection from rest at which the law is no longer linear: beyond its gap, its slip, the doubling of its
/// stiffness.
struct Extent {
  double own_stiffness, at_rest;

  double operator()(const elements::ElasticForce& law) const {
    constexpr double beyond = 1.5;
    double extent = 0;
    if (const auto [low, high] = elements::range(law); std::isfinite(low) || std::isfinite(high))
      if (!std::holds_alternative<elements::GasForce>(law)) return std::min(at_rest - low, high - at_rest);
    for (const double kink : elements::kinks(law)) extent = std::max(extent, beyond * std::abs(kink - at_rest));
    constexpr double of_stroke = 0.3;
    if (const auto* gas = std::get_if<elements::GasForce>(&law)) return of_stroke * gas->volume / gas->area;
    const auto* polynomial = std::get_if<elements::PolynomialForce>(&law);
    if (!polynomial) return extent;
    const std::vector<double>& c = polynomial->coefficients;
    const double linear = std::abs(own_stiffness) + (c.empty() ? 0 : std::abs(c[0]));
    for (std::size_t i = 1; i < c.size(); ++i)
      if (c[i] != 0 && linear > 0)
        extent = std::max(extent, std::pow(linear / std::abs(c[i]), 1 / static_cast<double>(i)));
    return extent;
  }
  double operator()(const elements::HystereticForce& law) const {
    constexpr double of_its_slip = 5, without_spring = 1e-3;
    if (!(elements::initial_stiffness(law) > 0)) return without_spring;
    return of_its_slip * elements::force_limit(law) / elements::initial_stiffness(law);
  }
  double operator()(const elements::LuGreFriction& law) const {
    constexpr double of_its_limit = 5;
    return of_its_limit * law.limit() / law.stiffness;
  }
  double operator()(const elements::DampingForce&) const { return 0; }
  double operator()(const elements::PayneForce& law) const {
    constexpr double of_its_amplitude = 20;
    return of_its_amplitude * law.amplitude;
  }
};

LawLoop loop(const LawHarmonics& law, double at_rest, double force_at_rest, double amplitude) {
  LawLoop found;
  found.amplitude = amplitude;
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(numerics::coefficient_count(20));
  motion(1) = amplitude;  // the largest deflection at phase 0
  const LawOverPeriod course = law.course(motion, 0);
  const Eigen::VectorXd harmonics = law.force_at(motion, 0);
  found.storage = harmonics(1) / amplitude;
  found.loss = -harmonics(2) / amplitude;
  found.energy = two_pi / 2 * amplitude * amplitude * found.loss;
  constexpr int samples = 96;
  for (int i = 0; i <= samples; ++i) {
    const double phase = two_pi * i / samples, deviation = course.deflection_at(phase);
    double force = force_at_rest + course.at(phase).force;
    for (const HystereticLoop& one : course.loops()) force += one.at(one.branch_at(phase), deviation).force;
    for (const BristleLoop& one : course.bristles()) force += one.at(phase).force;
    found.deflections.push_back(at_rest + deviation);
    found.forces.push_back(force);
  }
  return found;
}

}  // namespace

std::vector<LawLoop> law_loops(const model::NonlinearPart& part, double own_stiffness) {
  double extent = 0;
  elements::ScalarLaws slow;
  for (const elements::ScalarLaw& law : part.laws) {
    extent = std::max(extent, std::visit(Extent{own_stiffness, part.at_rest}, law));
    if (!std::holds_alternative<elements::DampingForce>(law)) slow.push_back(law);
  }
  const auto [low, high] = DeviationLaw(slow).range();
  extent = std::min({extent, part.at_rest - low, high - part.at_rest});
  std::vector<LawLoop> loops;
  if (slow.empty() || !(extent > 0)) return loops;
  const LawHarmonics law(DeviationLaw(slow, part.at_rest), 20);
  for (const double share : {0.05, 0.1, 0.2, 0.5, 1.0})
    loops.push_back(loop(law, part.at_rest, elements::force_at_rest(slow, part.at_rest).force, share * extent));
  return loops;
}

}  // namespace trivet::nonlinear
