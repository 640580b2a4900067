// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/model/checks.h"
#include "trivet/model/point_mass.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::model {
namespace {

/// Component of a force in a direction that is left out, as a share of the force, that is rounding of its axes.
constexpr double rounding_of_axes = 1e-12;

/// "translation along y", "rotation about z".
std::string direction_name(std::size_t j) {
  return fmt::format("{} {}", j < 3 ? "translation along" : "rotation about", "xyz"[j % 3]);
}

void check_ends(const Description& description, std::size_t node, foundation::Problems& problems) {
  const std::string path = path_of(description.bodies[node]);
  std::vector<std::string> joined;
  for (const Element& element : description.elements)
    if (element.n.body == node || element.k.body == node) joined.push_back(element.name);
  if (joined.empty())
    problems.error(path, "no element", "a node is a place where elements meet",
                   "name it in `on` or `from` of an element, or remove it");
  if (joined.size() == 1)
    problems.warning(path, "only \"" + joined.front() + "\" ends on it", "a node joins elements",
                     "add the other element, or remove the node: without one, the element carries only a force that "
                     "acts on the node");
}

void leave_out(Description& description, std::size_t node, foundation::Problems& problems) {
  Body& body = description.bodies[node];
  const std::array<bool, 6> held = held_directions(description, node);
  bool any = false;
  for (std::size_t j = 0; j < 6; ++j) {
    if (body.free[j] && is_massless(body, j) && !held[j]) body.left_out[j] = true;
    if (body.left_out[j]) body.free[j] = false;
    any = any || body.free[j];
  }
  if (!any && body.is_node)
    problems.error(path_of(body) + ".free", "no element holds any of its free directions",
                   "a node moves with the elements that end on it", "add an element, or remove the node");
}

/// Reports a force along a direction that is left out.
/// @param force  force and moment at `at`, axes of the node
void check_force(const Body& node, const std::string& subject, const Action::Amplitude& force,
                 const Eigen::Vector3d& at, foundation::Problems& problems) {
  const Action::Amplitude at_node = spatial::rigid_motion(at).transpose().cast<std::complex<double>>() * force;
  const double linear = force.head<3>().norm(), angular = force.tail<3>().norm() + at.norm() * linear;
  for (std::size_t j = 0; j < 6; ++j)
    if (node.left_out[j] && std::abs(at_node(to_index(j))) > rounding_of_axes * (j < 3 ? linear : angular))
      problems.error(subject,
                     fmt::format("it acts on the {} of {} \"{}\"", direction_name(j),
                                 node.is_node ? "node" : "point mass", node.name),
                     "no element holds this direction, so it is left out",
                     "add an element that holds it, or change the direction of the force");
}

void check_forces(const Description& description, foundation::Problems& problems) {
  for (const Excitation& excitation : description.excitations) {
    const Action& action = excitation.action;
    if (!action.body || !turns_without_mass(description.bodies[*action.body])) continue;
    const Body& node = description.bodies[*action.body];
    const std::string subject = "excitations." + excitation.name;
    if (const auto* orders = std::get_if<Orders>(&excitation.course)) {
      for (const excitation::Order& order : orders->list)
        for (const auto* part : {&order.per_speed_squared, &order.fixed})
          check_force(node, subject, *part, action.at, problems);
    } else {
      check_force(node, subject, action.amplitude, action.at, problems);
    }
  }
  for (const ConstantForce& force : description.constant_forces) {
    Action::Amplitude six;
    six << force.wrench.force.cast<std::complex<double>>(), force.wrench.moment.cast<std::complex<double>>();
    if (turns_without_mass(description.bodies[force.body]))
      check_force(description.bodies[force.body], "excitations." + force.name, six, force.at, problems);
  }
}

/// "translation along y", "rotation about (0.6, 0.8, 0)", "translation along x with rotation about z".
std::string motion_name(const UnheldMotion& motion) {
  std::string words;
  for (const Eigen::Index first : {0, 3}) {
    const Eigen::Vector3d part = motion.directions.segment<3>(first);
    if (part.isZero(0)) continue;
    Eigen::Index largest = 0;
    part.cwiseAbs().maxCoeff(&largest);
    constexpr double one_axis = 0.9999, nothing = 5e-4;
    const Eigen::Vector3d unit = (part / part.norm() * (part(largest) < 0 ? -1 : 1)).unaryExpr([](double x) {
      return std::abs(x) < nothing ? 0.0 : x;
    });
    words += (words.empty() ? "" : " with ") + std::string(first == 0 ? "translation along " : "rotation about ");
    if (unit(largest) > one_axis) words += "xyz"[largest];
    else words += fmt::format("({:.3g}, {:.3g}, {:.3g})", unit.x(), unit.y(), unit.z());
  }
  return words;
}

void check_held(const Description& description, foundation::Problems& problems) {
  for (const UnheldMotion& motion : unheld_motions(description)) {
    const Body& body = description.bodies[motion.node];
    const std::string remedy =
        "add an element with stiffness in this direction, or remove it from `free`: it is then fixed in space";
    if (motion.only_dampers)
      problems.error(path_of(body), "only dampers hold its " + motion_name(motion),
                     "a direction without mass needs a stiffness: without one it has no position at rest", remedy);
    else if (motion.with.empty())
      problems.error(path_of(body), "no element holds its " + motion_name(motion),
                     "elements must hold every free direction of a node; only directions along its own axes that no "
                     "element touches are left out",
                     remedy);
    else
      problems.error(path_of(body),
                     fmt::format("no element holds its {} together with {}{}", motion_name(motion), motion.with,
                                 motion.further > 0 ? fmt::format(", and {} more such motions", motion.further) : ""),
                     "elements must hold every motion of nodes, which have no mass", remedy);
  }
}

}  // namespace

void settle_nodes(Description& description, foundation::Problems& problems) {
  const std::size_t before = problems.errors();
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    if (!turns_without_mass(description.bodies[b])) continue;
    const std::size_t errors = problems.errors();
    if (description.bodies[b].is_node) check_ends(description, b, problems);
    if (problems.errors() == errors) leave_out(description, b, problems);
  }
  if (problems.errors() > before) return;
  check_forces(description, problems);
  check_held(description, problems);
}

std::vector<std::string> left_out_notes(const Description& description) {
  std::vector<std::string> notes;
  for (const Body& body : description.bodies) {
    std::string names;
    int count = 0;
    for (const std::size_t first : {0U, 3U}) {
      std::string axes;
      for (std::size_t j = first; j < first + 3; ++j) {
        if (!body.left_out[j]) continue;
        axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[j % 3]);
        ++count;
      }
      if (!axes.empty())
        names +=
            (names.empty() ? "" : ", ") + std::string(first == 0 ? "translation along " : "rotation about ") + axes;
    }
    if (count > 0)
      notes.push_back(fmt::format("{} {}: {} {} held by no element and left out", body.is_node ? "node" : "point mass",
                                  body.name, names, count == 1 ? "is" : "are"));
  }
  return notes;
}

}  // namespace trivet::model
