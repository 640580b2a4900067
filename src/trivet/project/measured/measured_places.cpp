// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/measured_places.h"
#include "trivet/project/measured/universal_names.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "trivet/foundation/index.h"
#include "trivet/project/measured/measured_file.h"

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

}  // namespace trivet::project
