// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/observations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "trivet/foundation/plain_text.h"
#include "trivet/model/checks.h"
#include "trivet/model/system.h"

namespace trivet::model {
namespace {

/// Reports two places that cannot move against each other.
void check_places(const std::string& subject, const Place& of, const Place& to, foundation::Problems& problems) {
  if (of.body != to.body) return;
  const bool same = !of.body || of.at == to.at;
  problems.error(subject,
                 same ? fmt::format("{} and itself", foundation::quoted(of.name))
                      : fmt::format("{} and {}, both on {}", foundation::quoted(of.name), foundation::quoted(to.name),
                                    foundation::quoted(of.name.substr(0, of.name.find('.')))),
                 same ? "a place does not move against itself" : "a rigid body does not deform",
                 "name places of two bodies, or of a body and \"ground\"");
}

void check_directions(const Description& description, const std::string& subject, const Place& of, const Place& to,
                      const Eigen::Vector3d& axis, foundation::Problems& problems) {
  for (const Place* place : {&of, &to})
    if (is_left_out(description.bodies, *place, axis, false))
      problems.error(subject, foundation::quoted(place->name),
                     "no element holds this direction of the node, so it is left out",
                     "add an element that holds it, or choose another direction");
}

void check_clearance(const Description& description, const Clearance& clearance, foundation::Problems& problems) {
  const std::string path = "clearances." + clearance.name;
  check_places(path + ".between", clearance.of, clearance.to, problems);
  check_directions(description, path + ".between", clearance.of, clearance.to, clearance.direction, problems);
  if (!(clearance.gap > 0))
    problems.error(path + ".gap",
                   clearance.gap < 0 ? fmt::format("an overlap of {:.6g} m", -clearance.gap)
                                     : fmt::format("{:.6g} m", clearance.gap),
                   "a gap at rest, without gravity and constant forces, is above 0",
                   "give the free distance along `direction`, or remove the clearance");
  const auto from = position(description.bodies, clearance.of), to = position(description.bodies, clearance.to);
  if (!from || !to || clearance.of.body == clearance.to.body) return;
  const double apart = clearance.direction.dot(*to - *from);
  constexpr double beyond_rounding = 1e-6;  // of the distance: places beside each other are no mistake
  if (apart < -beyond_rounding * (*to - *from).norm())
    problems.warning(path + ".direction",
                     fmt::format("{} is {:.6g} m behind {} in this direction", foundation::quoted(clearance.to.name),
                                 -apart, foundation::quoted(clearance.of.name)),
                     "the direction points from the first place to the second: the first place closes the gap by "
                     "moving in this direction",
                     "turn the direction around, unless the parts reach past each other");
}

/// The body or flexible foundation of an end; none for the ground.
using Part = std::pair<std::optional<std::size_t>, std::optional<std::size_t>>;
Part part_of(const End& end) {
  return {end.body, end.foundation ? std::optional(end.foundation->foundation) : std::nullopt};
}

/// Reports elements that do not lead from one side of a section to the other.
void check_section(const Description& description, const Section& section, foundation::Problems& problems) {
  const std::string path = "sections." + section.name + ".elements";
  std::set<std::size_t> elements;
  std::set<Part> of_n;
  for (const std::size_t e : section.elements) {
    if (!elements.insert(e).second)
      problems.error(path, foundation::quoted(description.elements[e].name) + " twice",
                     "each element of a section counts once", "remove one of them");
    of_n.insert(part_of(description.elements[e].n));
  }
  for (const std::size_t e : elements)
    if (of_n.contains(part_of(description.elements[e].k)))
      problems.error(path,
                     foundation::quoted(description.elements[e].name) +
                         " is `on` a part that another element of the section, or itself, is `from`",
                     "the forces of a section act on one side of it: on the parts that its elements are `from`",
                     "exchange `on` and `from` of the elements on the wrong side, or leave them out");
}

/// Reports names that other results have. @param taken  names so far
void check_result_name(const std::string& path, const std::string& name, std::set<std::string>& taken,
                       foundation::Problems& problems) {
  if (name.empty() || name.find_first_of(".\n") != std::string::npos)
    problems.error(path, fmt::format("name \"{}\"", name), "a name is not empty, and has no dot and no line break",
                   "choose another name");
  else if (!taken.insert(name).second)
    problems.error(path, fmt::format("\"{}\" is also the name of another part", name),
                   "results are named after bodies, nodes, elements, relative motions, sections and clearances, so "
                   "these names must differ",
                   "rename one of them");
}

}  // namespace

std::optional<Eigen::Vector3d> position(const std::vector<Body>& bodies, const Place& place) {
  if (!place.body) return std::nullopt;
  const spatial::Pose& pose = bodies[*place.body].pose;
  return pose.position + pose.rotation * place.at;
}

bool is_left_out(const std::vector<Body>& bodies, const Place& place, const Eigen::Vector3d& axis, bool rotation) {
  if (!place.body) return false;
  const Body& body = bodies[*place.body];
  const Eigen::Vector3d along = body.pose.rotation.transpose() * axis;
  constexpr double nothing = 1e-12;  // rounding of the rotation
  for (int j = 0; j < 3; ++j)
    if (body.left_out[rotation ? j + 3 : j] && std::abs(along(j)) > nothing) return true;
  return false;
}

bool is_left_out(const std::vector<Body>& bodies, const RelativeMotion& motion, int j) {
  const Eigen::Vector3d axis = motion.axes.col(j % 3);
  return is_left_out(bodies, motion.of, axis, j >= 3) || is_left_out(bodies, motion.to, axis, j >= 3);
}

void check_observations(const Description& description, foundation::Problems& problems) {
  std::set<std::string> taken = {"ground", "base", "coordinates"};
  for (const Body& body : description.bodies) taken.insert(body.name);
  for (const Element& element : description.elements) taken.insert(element.name);
  for (const RelativeMotion& motion : description.relative_motions) {
    check_result_name("relative." + motion.name, motion.name, taken, problems);
    check_places("relative." + motion.name + ".to", motion.of, motion.to, problems);
  }
  for (const Section& section : description.sections) {
    check_result_name("sections." + section.name, section.name, taken, problems);
    check_section(description, section, problems);
  }
  for (const Clearance& clearance : description.clearances) {
    check_result_name("clearances." + clearance.name, clearance.name, taken, problems);
    check_clearance(description, clearance, problems);
  }
}

}  // namespace trivet::model
