// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/distance_about.h"

#include <algorithm>
#include <cmath>

namespace trivet::nonlinear {

using Eigen::Vector3d;

DistanceAbout::DistanceAbout(elements::DistanceForce law, const Vector3d& at_rest)
    : law_(std::move(law)),
      at_rest_(at_rest),
      there_(elements::force_in_motion(law_, at_rest, Vector3d::Zero())),
      kinks_(elements::kink_distances(law_)),
      has_dampers_(std::ranges::any_of(law_.laws, [](const elements::ScalarLaw& one) {
        const auto* elastic = std::get_if<elements::ElasticForce>(&one);
        return !elastic || elements::is_damped(*elastic);
      })) {}

DistanceAbout::DistanceAbout(elements::DistanceForce law, const Vector3d& at_rest, const Eigen::Matrix3d& stiffness)
    : DistanceAbout(std::move(law), at_rest) {
  there_.by_deflection = stiffness;
}

elements::SpatialForce DistanceAbout::at(const Vector3d& deviation, const Vector3d& rate) const {
  elements::SpatialForce found = elements::force_in_motion(law_, at_rest_ + deviation, rate);
  found.force -= there_.force + there_.by_deflection * deviation + there_.by_rate * rate;
  found.by_deflection -= there_.by_deflection;
  found.by_rate -= there_.by_rate;
  return found;
}

double DistanceAbout::energy(const Vector3d& deviation) const {
  return elements::elastic_energy(law_, at_rest_ + deviation) - elements::elastic_energy(law_, at_rest_) -
      there_.force.dot(deviation) - deviation.dot(there_.by_deflection * deviation) / 2;
}

std::pair<double, double> DistanceAbout::range() const {
  std::pair<double, double> common = elements::range(elements::PolynomialForce{});
  for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(law_.laws)) {
    const auto [low, high] = elements::range(law);
    common = {std::max(common.first, low + law_.length), std::min(common.second, high + law_.length)};
  }
  return common;
}

double DistanceAbout::extent() const {
  constexpr double of_distance = 0.1;
  const double distance = law_.distance(at_rest_);
  double found = of_distance * distance;
  for (const double kink : kinks_) found = std::max(found, std::abs(kink - distance));
  return found;
}

}  // namespace trivet::nonlinear
