// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/measured_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/measured/measured_file.h"
#include "trivet/project/measured/universal_names.h"

namespace trivet::project {

MeasuredPlaces::MeasuredPlaces(const model::Description& description, std::map<int, Eigen::Vector3d> nodes,
                               std::map<int, Eigen::Matrix3d> axes)
    : description_(description), nodes_(std::move(nodes)), axes_(std::move(axes)) {
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const model::Body& body = description.bodies[b];
    const auto add = [&](const std::string& name, const Eigen::Vector3d& at) {
      places_.push_back({name, b, at, body.pose.position + body.pose.rotation * at});
    };
    add(body.name, Eigen::Vector3d::Zero());
    for (const model::Point& point : body.points) add(body.name + "." + point.name, point.at);
  }
}

bool MeasuredPlaces::put(int node, const std::string& place) {
  const auto found = std::ranges::find_if(places_, [&](const auto& one) { return one.name == place; });
  if (found == places_.end()) return false;
  put_[node] = to_size(found - places_.begin());
  return true;
}

const MeasuredPlace* MeasuredPlaces::place(int node) const {
  if (const auto given = put_.find(node); given != put_.end()) return &places_[given->second];
  const auto known = nodes_.find(node);
  if (known == nodes_.end()) return nullptr;
  const MeasuredPlace* found = nullptr;
  for (const MeasuredPlace& one : places_) {
    if ((one.position - known->second).norm() > same_place) continue;
    if (found && found->body != one.body) return nullptr;
    if (!found) found = &one;
  }
  return found;
}

std::optional<Eigen::Vector3d> MeasuredPlaces::position(int node) const {
  if (const MeasuredPlace* at = place(node)) return at->position;
  const auto known = nodes_.find(node);
  return known == nodes_.end() ? std::nullopt : std::optional(known->second);
}

Eigen::Vector3d MeasuredPlaces::direction_in_ground(const exchange::UniversalPoint& point) const {
  const auto own = axes_.find(point.node);
  const int axis = (std::abs(point.direction) - 1) % 3;
  const Eigen::Vector3d along =
      own == axes_.end() ? Eigen::Vector3d::Unit(axis) : Eigen::Vector3d(own->second.col(axis));
  return point.direction < 0 ? Eigen::Vector3d(-along) : along;
}

std::optional<MeasuredPlaces::Component> MeasuredPlaces::component(const exchange::UniversalPoint& point) const {
  constexpr double parallel = 1 - 1e-6;
  const int direction = std::abs(point.direction);
  const MeasuredPlace* at = place(point.node);
  if (!at || direction < 1 || direction > 6) return std::nullopt;
  const Eigen::Vector3d along = description_.bodies[at->body].pose.rotation.transpose() * direction_in_ground(point);
  for (int j = 0; j < 3; ++j)
    if (std::abs(along(j)) > parallel)
      return Component{at->name + "." + model::coordinate_names[direction > 3 ? j + 3 : j], along(j) < 0 ? -1.0 : 1.0};
  return std::nullopt;
}

std::string MeasuredPlaces::words(const exchange::UniversalPoint& point) const {
  const MeasuredPlace* at = place(point.node);
  return point_name(point) + (at ? " at " + at->name : "");
}

std::vector<std::string> MeasuredPlaces::names() const {
  std::vector<std::string> list;
  for (const MeasuredPlace& one : places_) list.push_back(one.name);
  return list;
}

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

namespace {

using exchange::UniversalNode;

std::set<int> labels_with_results(const exchange::UniversalFile& file) {
  std::set<int> labels;
  for (const exchange::UniversalFunction& function : file.functions)
    labels.insert({function.response.node, function.reference.node});
  for (const exchange::UniversalMode& mode : file.modes)
    for (const exchange::UniversalNodeMotion& node : mode.nodes) labels.insert(node.node);
  return labels;
}

/// "3, 4, 5".
std::string labels_of(const std::vector<UniversalNode>& nodes) {
  std::vector<std::string> texts;
  for (const UniversalNode& node : nodes) texts.push_back(std::to_string(node.label));
  return foundation::comma_separated(texts);
}

}  // namespace

std::vector<UniversalNode> nodes_in_systems(const exchange::UniversalFile& file) {
  const std::set<int> measured = labels_with_results(file);
  std::vector<UniversalNode> nodes;
  for (const UniversalNode& node : file.nodes)
    if ((!node.position_known || !node.axes_known) && measured.contains(node.label)) nodes.push_back(node);
  return nodes;
}

foundation::Problems judge_directions(const std::vector<UniversalNode>& nodes) {
  std::vector<UniversalNode> turned;
  std::ranges::copy_if(nodes, std::back_inserter(turned), [](const UniversalNode& node) { return !node.axes_known; });
  foundation::Problems found;
  if (!turned.empty())
    found.warning("",
                  "displacements of the nodes " + labels_of(turned) +
                      " in a coordinate system not 0 that the file does not define",
                  "sets 18 and 2420 define coordinate systems; spherical ones are not applied",
                  "their directions are read as axes of the ground; check that they are");
  return found;
}

std::optional<exchange::UniversalPoint> in_ground(const exchange::UniversalPoint& point,
                                                  const std::vector<UniversalNode>& nodes) {
  constexpr double parallel = 1 - 1e-6;
  const auto node = std::ranges::find(nodes, point.node, &UniversalNode::label);
  const int direction = std::abs(point.direction);
  if (node == nodes.end() || direction < 1 || direction > 6) return point;
  const Eigen::Vector3d along = node->axes.col((direction - 1) % 3);
  Eigen::Index axis = 0;
  if (along.cwiseAbs().maxCoeff(&axis) < parallel) return std::nullopt;
  exchange::UniversalPoint turned = point;
  turned.direction = static_cast<int>(axis) + (direction > 3 ? 4 : 1);
  if ((along(axis) < 0) != (point.direction < 0)) turned.direction = -turned.direction;
  return turned;
}

void turn_to_ground(const std::vector<UniversalNode>& nodes, std::vector<exchange::UniversalMode>& modes) {
  std::map<int, Eigen::Matrix3d> axes;
  for (const UniversalNode& node : nodes)
    if (!node.axes.isIdentity(0)) axes[node.label] = node.axes;
  if (axes.empty()) return;
  for (exchange::UniversalMode& mode : modes)
    for (exchange::UniversalNodeMotion& node : mode.nodes) {
      const auto own = axes.find(node.node);
      if (own == axes.end()) continue;
      for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
        const Eigen::Vector3cd turned = own->second.cast<std::complex<double>>() *
            Eigen::Vector3cd(node.components[first], node.components[first + 1], node.components[first + 2]);
        for (std::size_t i = 0; i < 3; ++i) node.components[first + i] = turned(static_cast<Eigen::Index>(i));
      }
    }
}

foundation::Problems judge_positions(const std::vector<UniversalNode>& nodes) {
  foundation::Problems found;
  if (!nodes.empty())
    found.warning("", "the nodes " + labels_of(nodes) + " in a coordinate system not 0 that the file does not define",
                  "sets 18 and 2420 define coordinate systems; such a node has no place by its position",
                  "add nodes = {\"" + std::to_string(nodes.front().label) + "\" = \"BODY.POINT\"}");
  return found;
}

}  // namespace trivet::project
