// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/deviation_law.h"

#include <algorithm>
#include <cmath>

namespace trivet::nonlinear {

using Eigen::VectorXd;

namespace {

void make_ascending(std::vector<double>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
}

elements::ForcesInMotion none(Eigen::Index count) {
  return {VectorXd::Zero(count), VectorXd::Zero(count), VectorXd::Zero(count)};
}

}  // namespace

DeviationLaw::DeviationLaw(elements::ScalarLaws laws, double state, elements::SmallMotion reference,
                           double acceleration_per_force)
    : laws_(std::move(laws)),
      elastic_(elements::only<elements::ElasticForce>(laws_)),
      dampers_(elements::only<elements::DampingForce>(laws_)),
      of_amplitude_(elements::only<elements::PayneForce>(laws_)),
      state_(state),
      offset_(elements::force_at_rest(laws_, state).force),
      acceleration_per_force_(acceleration_per_force),
      reference_(reference),
      has_dampers_(!dampers_.empty() || !of_amplitude_.empty()) {
  for (const elements::HystereticForce& law : elements::only<elements::HystereticForce>(laws_))
    hysteretic_.push_back({law, elements::virgin_force(law, state).force});
  for (const elements::LuGreFriction& law : elements::only<elements::LuGreFriction>(laws_))
    bristles_.push_back({law, elements::virgin_force(law, state).force});
  has_dampers_ = has_dampers_ || !bristles_.empty();
  for (const elements::ElasticForce& law : elastic_) {
    for (const double kink : elements::kinks(law)) kinks_.push_back(kink - state);
    for (const double kink : elements::rate_kinks(law)) rate_kinks_.push_back(kink);
    has_dampers_ = has_dampers_ || elements::is_damped(law);
    const bool is_smooth = elements::kinks(law).empty() && elements::rate_kinks(law).empty();
    (is_smooth ? smooth_ : elements::is_piecewise_bilinear(law) ? quadratic_ : others_).add(law);
  }
  for (const elements::DampingForce& law : dampers_) {
    for (const double kink : elements::kinks(law)) rate_kinks_.push_back(kink);
    (elements::is_piecewise_quadratic(law) ? quadratic_ : others_).add(law);
  }
  make_ascending(kinks_);
  make_ascending(rate_kinks_);
}

DeviationLaw::Force DeviationLaw::Parts::at(double deflection, double rate) const {
  Force sum;
  for (const elements::ElasticForce& law : elastic_) {
    const elements::ForceInMotion found = elements::force_in_motion(law, deflection, rate);
    sum.force += found.force;
    sum.by_deviation += found.by_deflection;
    sum.by_rate += found.by_rate;
  }
  for (const elements::DampingForce& law : dampers_) {
    const elements::ForceOfRate found = elements::force_of_rate(law, rate);
    sum.force += found.force;
    sum.by_rate += found.by_rate;
  }
  return sum;
}

elements::ForcesInMotion DeviationLaw::Parts::at(const VectorXd& deflections, const VectorXd& rates) const {
  elements::ForcesInMotion sums = none(deflections.size());
  for (const elements::ElasticForce& law : elastic_) elements::add_forces_in_motion(law, deflections, rates, sums);
  for (const elements::DampingForce& law : dampers_)
    for (Eigen::Index i = 0; i < rates.size(); ++i) {
      const elements::ForceOfRate found = elements::force_of_rate(law, rates(i));
      sums.force(i) += found.force;
      sums.by_rate(i) += found.by_rate;
    }
  return sums;
}

DeviationLaw::Parts::Curvature DeviationLaw::Parts::curvature(double deflection, double rate) const {
  Curvature sum;
  for (const elements::ElasticForce& law : elastic_) sum.mixed += elements::mixed_derivative(law, deflection, rate);
  for (const elements::DampingForce& law : dampers_) sum.by_rate += elements::curvature(law, rate);
  return sum;
}

DeviationLaw::Line DeviationLaw::line() const {
  Line found{-offset_, -reference_.stiffness, -reference_.damping};
  for (const Hysteretic& part : hysteretic_) found.constant += part.at_state;  // in the offset
  for (const Bristles& part : bristles_) found.constant += part.at_state;
  for (const elements::PayneForce& law : of_amplitude_)
    found.constant += elements::stiffness_at(law, std::abs(state_)).storage * state_;
  return found;
}

DeviationLaw::Force DeviationLaw::without_memory(double deviation, double rate) const {
  const Line straight = line();
  Force sum{straight.constant + straight.stiffness * deviation + straight.damping * rate, straight.stiffness,
            straight.damping};
  for (const Parts* parts : {&smooth_, &quadratic_, &others_}) {
    const Force found = parts->at(state_ + deviation, rate);
    sum.force += found.force;
    sum.by_deviation += found.by_deviation;
    sum.by_rate += found.by_rate;
  }
  return sum;
}

VectorXd DeviationLaw::elastic_tangents(const VectorXd& deviations) const {
  const VectorXd deflections = deviations.array() + state_, rates = VectorXd::Zero(deviations.size());
  elements::ForcesInMotion sums = none(deviations.size());
  for (const elements::ElasticForce& law : elastic_) elements::add_forces_in_motion(law, deflections, rates, sums);
  return sums.by_deflection.array() - reference_.stiffness;
}

elements::ForceAndTangent DeviationLaw::at_rest(double deviation) const {
  const elements::ForceAndTangent whole = elements::force_at_rest(laws_, state_ + deviation);
  return {whole.force - offset_ - reference_.stiffness * deviation, whole.tangent - reference_.stiffness};
}

double DeviationLaw::energy(double deviation) const {
  double sum = -reference_.stiffness * deviation * deviation / 2;
  for (const elements::ElasticForce& law : elastic_)
    sum += elements::elastic_energy(law, state_ + deviation) - elements::elastic_energy(law, state_) -
        elements::force_and_tangent(law, state_).force * deviation;
  return sum;
}

std::optional<int> DeviationLaw::degree() const {
  if (!dampers_.empty() || !hysteretic_.empty() || !of_amplitude_.empty() || !bristles_.empty()) return std::nullopt;
  int highest = 1;  // the reference
  for (const elements::ElasticForce& law : elastic_) {
    const auto* polynomial = std::get_if<elements::PolynomialForce>(&law);
    if (!polynomial) return std::nullopt;
    highest = std::max(highest, static_cast<int>(polynomial->coefficients.size()));
  }
  return highest;
}

bool DeviationLaw::is_piecewise_linear() const {
  const auto straight = [](const auto& law) { return elements::is_piecewise_linear(law); };
  return std::ranges::all_of(elastic_, straight) && std::ranges::all_of(dampers_, straight) &&
      std::ranges::all_of(hysteretic_,
                          [](const Hysteretic& part) { return elements::is_piecewise_linear(part.law); }) &&
      bristles_.empty();
}

std::pair<double, double> DeviationLaw::untouched() const {
  std::pair<double, double> between = elements::range(elements::PolynomialForce{});
  for (const elements::ElasticForce& law : elastic_)
    if (const auto* stop = std::get_if<elements::GapStop>(&law))
      between = {std::max(between.first, stop->lower() - state_), std::min(between.second, stop->upper() - state_)};
  return between;
}

std::pair<double, double> DeviationLaw::range() const {
  std::pair<double, double> common = elements::range(elements::PolynomialForce{});
  for (const elements::ElasticForce& law : elastic_) {
    const auto [low, high] = elements::range(law);
    common = {std::max(common.first, low - state_), std::min(common.second, high - state_)};
  }
  return common;
}

}  // namespace trivet::nonlinear
