// SPDX-License-Identifier: BSD-3-Clause
#include "support/random_system.h"

#include <gtest/gtest.h>

#include "trivet/elements/law.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::test {

Eigen::Vector3d RandomSystem::vector(double size) {
  return {number(-size, size), number(-size, size), number(-size, size)};
}

Eigen::Matrix3d RandomSystem::rotation() {
  return spatial::rotation_about(vector(1) + Eigen::Vector3d(0, 0, 2), number(-3, 3));
}

model::Body RandomSystem::body(const std::string& name) {
  model::Body body;
  body.name = name;
  body.pose = {vector(1), rotation()};
  std::vector<std::pair<double, Eigen::Vector3d>> cloud;
  for (int i = 0; i < 12; ++i) cloud.push_back({number(1, 20), vector(0.5)});
  Eigen::Matrix3d about_pole = Eigen::Matrix3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const auto& [m, r] : cloud) {
    body.mass.mass += m;
    moment += m * r;
    about_pole += m * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  body.mass = spatial::from_inertia_about_pole(body.mass.mass, moment / body.mass.mass, about_pole);
  body.points = {{"tip", vector(0.6)}};
  return body;
}

spatial::Matrix6 RandomSystem::stiffness(double translation, double length) {
  spatial::Matrix6 root;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) root(i, j) = number(-1, 1);
  root += 2 * spatial::Matrix6::Identity();
  spatial::Vector6 units;
  units << 1, 1, 1, length, length, length;
  return units.asDiagonal() * (translation * root * root.transpose()) * units.asDiagonal();
}

model::Element RandomSystem::element(const std::string& name, std::optional<std::size_t> from, std::size_t on,
                                     const std::vector<model::Body>& bodies, RandomDamping damping) {
  model::Element element;
  element.name = name;
  element.type = "matrix";
  element.k = {on, vector(0.5), rotation()};
  element.n = {from, vector(0.5), rotation()};
  const model::Span span = model::span(bodies, element.n, element.k);
  const auto full = [&](const spatial::Matrix6& k) {
    return elements::in_end_axes(elements::from_moved_end(k, span.arm), span.n_from_k);
  };
  element.law.nominal_stiffness = full(stiffness(number(2e4, 2e5), 0.2));
  element.law.scale = number(0.5, 2);
  if (damping == RandomDamping::proportional)
    element.law.damping = elements::ProportionalDamping{number(1e-4, 3e-3), false};
  if (damping == RandomDamping::viscous)
    element.law.damping = elements::DampingMatrix{full(stiffness(number(20, 400), 0.2))};
  if (damping == RandomDamping::loss) element.law.damping = elements::LossFactor{number(0.01, 0.2)};
  return element;
}

model::Description RandomSystem::description(std::size_t bodies, RandomDamping damping, bool grounded) {
  model::Description d;
  for (std::size_t i = 0; i < bodies; ++i) d.bodies.push_back(body("body " + std::to_string(i)));
  for (std::size_t i = 0; i < bodies; ++i) {
    if (i == 0 && !grounded) continue;
    const std::optional<std::size_t> from = i == 0 ? std::nullopt : std::optional(i - 1);
    for (int twice = 0; twice < 2; ++twice)
      d.elements.push_back(element("element " + std::to_string(d.elements.size()), from, i, d.bodies, damping));
  }
  model::Action force;
  force.body = bodies - 1;
  force.at = vector(0.4);
  const Eigen::Vector3d forces = vector(100), moments = vector(20);
  for (int j = 0; j < 6; ++j)
    force.amplitude(j) = (j < 3 ? forces(j) : moments(j - 3)) * std::polar(1.0, number(-3, 3));
  d.excitations.push_back({"force", force, model::Harmonic{}});
  return d;
}

model::System checked(const model::Description& description) {
  auto system = model::System::checked(description);
  if (!system)
    for (const auto& problem : system.error().list()) ADD_FAILURE() << foundation::message(problem);
  return system.value();
}

}  // namespace trivet::test
