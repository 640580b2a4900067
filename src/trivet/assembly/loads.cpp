// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/loads.h"

#include <algorithm>
#include <complex>

#include "trivet/foundation/invalid_input.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

/// Adds a wrench at a point of a body to the generalized forces: X(r)ᵀ w.
template <typename Scalar>
void add_wrench(const Layout& layout, std::size_t body, const Eigen::Vector3d& at, const Eigen::Matrix<Scalar, 6, 1>& wrench,
                Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& load) {
  const Eigen::Matrix<Scalar, 6, 1> at_pole = spatial::rigid_motion(at).transpose().template cast<Scalar>() * wrench;
  for (int j = 0; j < 6; ++j)
    if (layout.row(body, j) >= 0) load(layout.row(body, j)) += at_pole(j);
}

spatial::Vector6 six(const spatial::Wrench& wrench) {
  spatial::Vector6 v;
  v << wrench.force, wrench.moment;
  return v;
}

/// M times the acceleration of free fall of both ends.
void add_element_weight(const model::System& system, std::size_t index, const Eigen::Vector3d& gravity, const ElementMap& map, Eigen::VectorXd& load) {
  if (map.matrices.mass.isZero(0)) return;
  Eigen::VectorXd fall = Eigen::VectorXd::Zero(map.ends.rows());
  fall.segment<3>(0) = model::end_in_ground(system.bodies(), system.elements()[index].n).rotation.transpose() * gravity;
  fall.segment<3>(6) = model::end_in_ground(system.bodies(), system.elements()[index].k).rotation.transpose() * gravity;
  const Eigen::VectorXd weight = map.ends.transpose() * (map.matrices.mass * fall);
  for (Eigen::Index j = 0; j < weight.size(); ++j) load(map.rows[static_cast<std::size_t>(j)]) += weight(j);
}

/// What a preloaded element does at rest to the bodies that it carries.
void add_preload(const elements::Law& law, const ElementMap& map, Eigen::VectorXd& load) {
  if (!law.preload) return;
  const Eigen::VectorXd on_bodies = -(map.ends.topRows<12>().transpose() * *law.preload);
  for (Eigen::Index j = 0; j < on_bodies.size(); ++j) load(map.rows[static_cast<std::size_t>(j)]) += on_bodies(j);
}

}  // namespace

Eigen::VectorXcd harmonic_load(const model::System& system, const Layout& layout, const std::vector<std::string>& selected) {
  Eigen::VectorXcd load = Eigen::VectorXcd::Zero(layout.size());
  const auto& forces = system.description().harmonic_forces;
  for (const std::string& name : selected)
    if (std::none_of(forces.begin(), forces.end(), [&](const model::HarmonicForce& force) { return force.name == name; }))
      throw foundation::InvalidInput("\"" + name + "\" names no harmonic force of this model");
  for (const model::HarmonicForce& force : forces) {
    if (!selected.empty() && std::find(selected.begin(), selected.end(), force.name) == selected.end()) continue;
    Eigen::Matrix<std::complex<double>, 6, 1> wrench;
    const spatial::Vector6 amplitude = six(force.amplitude);
    for (int j = 0; j < 6; ++j)
      wrench(j) = force.phase(j) == 0 ? std::complex<double>(amplitude(j), 0) : amplitude(j) * std::exp(std::complex<double>(0, force.phase(j)));
    add_wrench<std::complex<double>>(layout, force.body, force.at, wrench, load);
  }
  return load;
}

Eigen::VectorXd static_load(const model::System& system, const Assembled& assembled) {
  const Layout& layout = assembled.layout;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(layout.size());
  const auto& bodies = system.bodies();
  if (system.description().gravity)
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      spatial::Wrench weight;
      weight.force = bodies[i].mass.mass * (bodies[i].pose.rotation.transpose() * *system.description().gravity);
      add_wrench<double>(layout, i, bodies[i].mass.centre, six(weight), load);
    }
  if (system.description().gravity)
    for (std::size_t e = 0; e < assembled.elements.size(); ++e) add_element_weight(system, e, *system.description().gravity, assembled.elements[e], load);
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) add_preload(system.elements()[e].law, assembled.elements[e], load);
  for (const model::ConstantForce& force : system.description().constant_forces)
    add_wrench<double>(layout, force.body, force.at, six(force.wrench), load);
  return load;
}

}  // namespace trivet::assembly
