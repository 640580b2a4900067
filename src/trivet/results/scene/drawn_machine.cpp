// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/scene/drawn_machine.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "trivet/model/point_mass.h"
#include "trivet/project/body_solids.h"

namespace trivet::results {
namespace {

using Complex6 = model::Action::Amplitude;

Eigen::Vector3d in_ground(const spatial::Pose& pose, const Eigen::Vector3d& at) {
  return pose.position + pose.rotation * at;
}

/// The solids of a body in its own axes: those given, or the box of its inertia if there are none, or not all can be
/// drawn.
std::vector<DrawnMachine::Solid> solids_of(const project::Case& machine, std::size_t index) {
  const model::Body& body = machine.system.bodies()[index];
  std::vector<DrawnMachine::Solid> result;
  const project::Node* bodies = machine.document.find("bodies");
  const project::Node* written = bodies ? bodies->find(body.name) : nullptr;
  const std::vector<solids::Part> parts = written ? project::body_solids(*written) : std::vector<solids::Part>();
  for (const solids::Part& part : parts)
    if (auto surface = surface_of(part)) result.push_back({index, std::move(*surface), false});
  const bool has_box = body.has_inertia && !model::is_point_mass(body);
  if (result.size() < parts.size() || result.empty()) {
    result.clear();
    if (has_box) result.push_back({index, equivalent_box(body.mass).surface(), true});
  }
  return result;
}

/// Direction of the larger part of Re(amplitude e^{iωt}) in a block, or the axis about which it turns.
void set_direction(DrawnMachine::Excitation& drawn, const Complex6& amplitude, const Eigen::Matrix3d& axes) {
  const Eigen::Vector3cd force = amplitude.head<3>(), moment = amplitude.tail<3>();
  constexpr double lever = 1e-9;  // [m] below which a moment is round-off of its force
  const Eigen::Vector3d about = force.real().cross(force.imag());
  constexpr double turning = 0.3;  // least share of a circle
  const auto line = [](const Eigen::Vector3cd& v) -> Eigen::Vector3d {
    return v.real().norm() >= v.imag().norm() ? v.real().normalized() : v.imag().normalized();
  };
  if (force.norm() > 0 && about.norm() > turning * force.squaredNorm() / 2) drawn.rotation = axes * about.normalized();
  else if (force.norm() > 0) drawn.force = axes * line(force);
  if (moment.norm() > lever * force.norm()) drawn.moment = axes * line(moment);
}

Complex6 amplitude_of(const model::Excitation& excitation) {
  const auto* orders = std::get_if<model::Orders>(&excitation.course);
  if (!orders) return excitation.action.amplitude;
  constexpr double speed = 100;  // [rad/s], only to compare orders
  Complex6 largest = Complex6::Zero();
  for (const excitation::Order& order : orders->list) {
    const Complex6 now = order.per_speed_squared * (speed * speed) + order.fixed;
    if (now.norm() > largest.norm()) largest = now;
  }
  return largest;
}

DrawnMachine::Excitation drawn_excitation(const model::Excitation& excitation, const model::System& system,
                                          const Eigen::Vector3d& middle_of_ground) {
  const model::Action& action = excitation.action;
  DrawnMachine::Excitation drawn{.name = excitation.name, .at = middle_of_ground, .body = action.body};
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (action.body) {
    const spatial::Pose& pose = system.bodies()[*action.body].pose;
    drawn.at = in_ground(pose, action.at);
    axes = pose.rotation;
  } else if (!action.elements.empty()) {
    drawn.at = model::end_in_ground(system.bodies(), system.elements()[action.elements.front()].n).position;
  }
  set_direction(drawn, amplitude_of(excitation), axes);
  return drawn;
}

DrawnMachine::Element drawn_element(const model::Element& element, const model::System& system) {
  const spatial::Pose n = model::end_in_ground(system.bodies(), element.n),
                      k = model::end_in_ground(system.bodies(), element.k);
  const auto support = element.n.body ? DrawnMachine::Support::body
      : element.n.foundation          ? DrawnMachine::Support::foundation
                                      : DrawnMachine::Support::ground;
  return {element.name,   n.position,     k.position, k.rotation.col(2),
          element.n.body, element.k.body, support,    element.type == "beam"};
}

}  // namespace

DrawnMachine drawn_machine(const project::Case& machine) {
  const model::System& system = machine.system;
  DrawnMachine drawn;
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const model::Body& body = system.bodies()[b];
    drawn.bodies.push_back(
        {body.name, body.pose, in_ground(body.pose, body.mass.centre), body.mass.mass, body.is_node});
    for (const model::Point& point : body.points)
      drawn.points.push_back({point.name, in_ground(body.pose, point.at), b});
    if (body.is_node) continue;
    for (DrawnMachine::Solid& solid : solids_of(machine, b)) {
      for (Eigen::Vector3d& v : solid.surface.vertices) v = in_ground(body.pose, v);
      drawn.solids.push_back(std::move(solid));
    }
  }
  std::vector<bool> named(system.description().foundations.size());
  Bounds ground;
  for (const model::Element& element : system.elements()) {
    if (element.is_foundation) continue;
    drawn.elements.push_back(drawn_element(element, system));
    const DrawnMachine::Element& last = drawn.elements.back();
    if (!element.n.body) ground.include(last.n);
    if (!element.n.foundation || named[element.n.foundation->foundation]) continue;
    named[element.n.foundation->foundation] = true;
    drawn.foundations.push_back({system.description().foundations[element.n.foundation->foundation].name, last.n});
  }
  const Eigen::Vector3d middle = ground.high.x() >= ground.low.x() ? ground.centre() : Eigen::Vector3d::Zero();
  for (const model::Excitation& excitation : system.description().excitations)
    drawn.excitations.push_back(drawn_excitation(excitation, system, middle));
  return drawn;
}

Bounds DrawnMachine::bounds() const {
  Bounds bounds;
  for (const Body& body : bodies) bounds.include(body.centre);
  for (const Solid& solid : solids)
    for (const Eigen::Vector3d& v : solid.surface.vertices) bounds.include(v);
  for (const Point& point : points) bounds.include(point.at);
  for (const Element& element : elements) {
    bounds.include(element.n);
    bounds.include(element.k);
  }
  for (const Excitation& excitation : excitations) bounds.include(excitation.at);
  return bounds;
}

Eigen::Vector3d DrawnMachine::nearest_on(std::size_t body, const Eigen::Vector3d& place) const {
  const spatial::Pose& pose = bodies[body].pose;
  const auto into_body = [&](const Eigen::Vector3d& r) -> Eigen::Vector3d {
    return pose.rotation.transpose() * (r - pose.position);
  };
  Eigen::Vector3d best = bodies[body].centre;
  bool found = false;
  const Eigen::Vector3d sought = into_body(place);
  for (const Solid& solid : solids) {
    if (solid.body != body) continue;
    Bounds box;
    for (const Eigen::Vector3d& v : solid.surface.vertices) box.include(into_body(v));
    const Eigen::Vector3d on = in_ground(pose, sought.cwiseMax(box.low).cwiseMin(box.high));
    if (!found || (on - place).norm() < (best - place).norm()) best = on;
    found = true;
  }
  return best;
}

}  // namespace trivet::results
