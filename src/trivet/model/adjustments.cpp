// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/adjustments.h"

#include <cassert>
#include <cmath>

#include "trivet/model/element_directions.h"

namespace trivet::model {

std::string_view stiffness_key(const Element& element) {
  if (element.law.nominal_stiffness.isZero(0) || element.over_deflection) return {};
  return element.law.preload ? "stiffness_factor.all" : "scale";
}

void add_deformation_stiffness(Description& description, std::size_t element, double gain) {
  Element& changed = description.elements[element];
  const ElementDirections directions = element_directions(description.bodies, changed);
  changed.law.nominal_stiffness += gain * between_ends(directions, directions.stiffness) / changed.law.scale;
}

void scale_stiffness_by_direction(Description& description, std::size_t element, const spatial::Vector6& factors) {
  assert((factors.array() >= 0).all() && "S K S with S = diag √factor keeps K symmetric");
  Element& changed = description.elements[element];
  const ElementDirections directions = element_directions(description.bodies, changed);
  const spatial::Vector6 s = factors.cwiseSqrt();
  const spatial::Matrix6 gained = s.asDiagonal() * directions.stiffness * s.asDiagonal() - directions.stiffness;
  changed.law.nominal_stiffness += between_ends(directions, gained) / changed.law.scale;
}

bool has_plain_stiffness(const Element& element) { return !element.law.inertia && !element.law.frequency_dependence; }

bool has_damping(const Element& element) {
  const elements::Damping& damping = element.law.damping;
  if (const auto* given = std::get_if<elements::DampingMatrix>(&damping)) return !given->matrix.isZero(0);
  if (const auto* loss = std::get_if<elements::LossFactor>(&damping)) return loss->value > 0;
  if (const auto* proportional = std::get_if<elements::ProportionalDamping>(&damping)) return proportional->factor > 0;
  return std::holds_alternative<elements::Viscoelastic>(damping);
}

void scale_damping(Description& description, std::size_t element, double factor) {
  elements::Damping& damping = description.elements[element].law.damping;
  if (auto* given = std::get_if<elements::DampingMatrix>(&damping)) given->matrix *= factor;
  if (auto* loss = std::get_if<elements::LossFactor>(&damping)) loss->value *= factor;
  if (auto* proportional = std::get_if<elements::ProportionalDamping>(&damping)) proportional->factor *= factor;
  if (auto* relaxing = std::get_if<elements::Viscoelastic>(&damping)) {
    if (auto* viscous = std::get_if<elements::KelvinVoigt>(relaxing)) viscous->time *= factor;
    if (auto* zener = std::get_if<elements::Zener>(relaxing)) zener->ratio *= factor;
    if (auto* fractional = std::get_if<elements::FractionalZener>(relaxing)) fractional->ratio *= factor;
    if (auto* series = std::get_if<elements::GeneralizedMaxwell>(relaxing))
      for (double& ratio : series->ratios) ratio *= factor;
  }
}

void move_element(Description& description, std::size_t element, const Eigen::Vector3d& by) {
  Element& moved = description.elements[element];
  const auto rotation = [&](const End& end) {
    return end.body ? description.bodies[*end.body].pose.rotation : Eigen::Matrix3d::Identity().eval();
  };
  const Eigen::Vector3d in_ground = rotation(moved.k) * by;
  moved.k.at += by;
  moved.n.at += rotation(moved.n).transpose() * in_ground;
  if (!moved.n.foundation) return;
  for (Element& joint : description.elements) {
    if (!joint.is_foundation) continue;
    const bool here = joint.k.foundation && joint.k.foundation->foundation == moved.n.foundation->foundation;
    if (here) joint.k.at = moved.n.at;
    if (here && joint.n.on_ground()) joint.n.at = moved.n.at;
    if (joint.n.foundation && joint.n.foundation->foundation == moved.n.foundation->foundation) joint.n.at = moved.n.at;
  }
}

void scale_mass(Description& description, std::size_t body, double factor) {
  description.bodies[body].mass.mass *= factor;
}

void move_center_of_mass(Description& description, std::size_t body, const Eigen::Vector3d& by) {
  description.bodies[body].mass.centre += by;
}

void change_inertia(Description& description, std::size_t body, int i, int j, double share) {
  assert(i >= 0 && i < 3 && j >= 0 && j < 3);
  Eigen::Matrix3d& tensor = description.bodies[body].mass.inertia_about_centre;
  // Jxy = ∫xy dm has a minus sign in the tensor.
  const double unit = i == j ? tensor(i, i) : -std::sqrt(std::abs(tensor(i, i) * tensor(j, j)));
  tensor(i, j) += share * unit;
  if (i != j) tensor(j, i) += share * unit;
}

void scale_modal_damping(Description& description, double factor) {
  if (auto* modal = std::get_if<ModalDamping>(&description.damping))
    for (double& ratio : modal->ratios) ratio *= factor;
}

}  // namespace trivet::model
