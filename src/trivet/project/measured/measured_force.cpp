// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/measured_force.h"

#include <fmt/format.h>

#include <cstdlib>
#include <variant>

#include "trivet/foundation/index.h"

namespace trivet::project {
namespace {

constexpr double rounding_of_direction = 1e-6;

/// Component of a complex force along a unit vector; none if there is a part across it.
std::optional<std::complex<double>> component_along(const Eigen::Vector3cd& force, const Eigen::Vector3d& direction) {
  const std::complex<double> along = (direction.transpose().cast<std::complex<double>>() * force)(0);
  const Eigen::Vector3cd across = force - along * direction.cast<std::complex<double>>();
  if (!(std::abs(along) > 0) || across.norm() > rounding_of_direction * std::abs(along)) return std::nullopt;
  return along;
}

}  // namespace

std::optional<std::string> MeasuredForce::unsuitable() const {
  const auto* harmonic = std::get_if<model::Harmonic>(&force_.course);
  if (!harmonic || !force_.action.body) return "a motion of the ground";
  if (harmonic->power_of_frequency != 0) return "an unbalance, whose force depends on speed";
  const bool turns = !force_.action.amplitude.tail<3>().isZero(0);
  if (turns && !force_.action.amplitude.head<3>().isZero(0)) return "a force together with a moment";
  return std::nullopt;
}

std::optional<std::complex<double>> MeasuredForce::along_itself() const {
  const bool turns = !force_.action.amplitude.tail<3>().isZero(0);
  const Eigen::Vector3cd load = turns ? force_.action.amplitude.tail<3>() : force_.action.amplitude.head<3>();
  for (int j = 0; j < 3; ++j)
    if (const auto along = component_along(load, Eigen::Vector3d::Unit(j))) return along;
  if (load.imag().isZero(0)) return load.norm();
  return std::nullopt;
}

bool MeasuredForce::acts_at(int node) const {
  const model::Body& body = description_.bodies[*force_.action.body];
  const MeasuredPlace* place = places_.place(node);
  const auto position = places_.position(node);
  if (!position || (place && place->body != *force_.action.body)) return false;
  if ((*position - body.pose.position - body.pose.rotation * force_.action.at).norm() <= same_place) return true;
  const bool turns = !force_.action.amplitude.tail<3>().isZero(0);
  return turns && (place || description_.bodies.size() == 1);
}

std::optional<std::complex<double>> MeasuredForce::amplitude(const exchange::UniversalPoint& reference) const {
  if (reference.node == 0) return along_itself();
  const model::Body& body = description_.bodies[*force_.action.body];
  const int direction = std::abs(reference.direction);
  const bool turns = !force_.action.amplitude.tail<3>().isZero(0);
  if (direction < 1 || direction > 6 || (direction > 3) != turns || !acts_at(reference.node)) return std::nullopt;
  const Eigen::Vector3d along = body.pose.rotation.transpose() * places_.direction_in_ground(reference);
  return component_along(turns ? force_.action.amplitude.tail<3>() : force_.action.amplitude.head<3>(), along);
}

std::string MeasuredForce::words() const {
  const model::Body& body = description_.bodies[*force_.action.body];
  const Eigen::Vector3d at = body.pose.position + body.pose.rotation * force_.action.at;
  const bool turns = !force_.action.amplitude.tail<3>().isZero(0);
  const Eigen::Vector3cd load = turns ? force_.action.amplitude.tail<3>() : force_.action.amplitude.head<3>();
  return fmt::format("{} of {} at ({:.4g}, {:.4g}, {:.4g}) m along ({:.3g}, {:.3g}, {:.3g}) of \"{}\"",
                     turns ? "moment" : "force", force_.name, at.x(), at.y(), at.z(), std::abs(load(0)),
                     std::abs(load(1)), std::abs(load(2)), body.name);
}

}  // namespace trivet::project
