// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/universal_model.h"

#include <algorithm>
#include <array>

#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::exports {
namespace {

using exchange::UniversalPoint;

/// A place with its position, and the body that carries it.
class Builder {
 public:
  explicit Builder(const model::System& system) : system_(system) {}

  int add(const std::string& name, const spatial::Pose& pose) {
    const int label = static_cast<int>(geometry_.nodes.size()) + 1;
    geometry_.places.push_back({label, name, pose.rotation});
    geometry_.nodes.push_back({label, pose.position});
    return label;
  }
  void line(const std::string& name, std::vector<int> nodes) {
    geometry_.lines.push_back({static_cast<int>(geometry_.lines.size()) + 1, name, std::move(nodes)});
  }

  UniversalGeometry built() {
    for (const model::Body& body : system_.bodies()) {
      const int pole = add(body.name, body.pose);
      for (const auto& point : body.points) {
        const int at =
            add(body.name + "." + point.name, {body.pose.position + body.pose.rotation * point.at, body.pose.rotation});
        line(body.name, {pole, at});
      }
    }
    for (const model::Element& element : system_.elements()) {
      const int foot = add(element.name + ".foot", model::end_in_ground(system_.bodies(), element.n));
      const int head = add(element.name + ".head", model::end_in_ground(system_.bodies(), element.k));
      line(element.name, {foot, head});
      if (element.k.body)
        line(system_.bodies()[*element.k.body].name, {geometry_.label(system_.bodies()[*element.k.body].name), head});
    }
    return std::move(geometry_);
  }

 private:
  const model::System& system_;
  UniversalGeometry geometry_;
};

/// Direction 1 … 6 of a component of a wrench, "mount.moment.x"; 0 for another result.
int direction_of_wrench(const std::string& result) {
  constexpr std::array<const char*, 6> parts = {".force.x",  ".force.y",  ".force.z",
                                                ".moment.x", ".moment.y", ".moment.z"};
  for (std::size_t j = 0; j < parts.size(); ++j)
    if (result.ends_with(parts[j])) return static_cast<int>(j) + 1;
  return 0;
}

}  // namespace

int UniversalGeometry::label(const std::string& name) const {
  const auto found = std::ranges::find(places, name, &UniversalPlace::name);
  return found == places.end() ? 0 : found->label;
}

UniversalGeometry universal_geometry(const model::System& system) { return Builder(system).built(); }

UniversalPoint universal_point(const UniversalGeometry& geometry, const std::string& result) {
  const std::size_t dot = result.rfind('.');
  if (dot == std::string::npos) return {};
  if (const int direction = direction_of_wrench(result); direction > 0) {
    const std::string group = result.substr(0, result.rfind('.', dot - 1));
    return {"", geometry.label(group + ".foot"), direction};
  }
  const auto component = std::ranges::find(model::coordinate_names, result.substr(dot + 1));
  const std::string name = result.substr(0, dot);
  const auto place = std::ranges::find(geometry.places, name, &UniversalPlace::name);
  if (component == model::coordinate_names.end() || place == geometry.places.end()) return {};
  const auto index = static_cast<int>(component - model::coordinate_names.begin());
  const Eigen::Vector3d axis = place->axes.col(index % 3);
  Eigen::Index along = 0;
  constexpr double same_axis = 1 - 1e-9;
  if (axis.cwiseAbs().maxCoeff(&along) < same_axis) return {"", 0, index + 1};  // still a translation or a rotation
  const int direction = static_cast<int>(along) + 1 + (index < 3 ? 0 : 3);
  return {"", place->label, axis(along) > 0 ? direction : -direction};
}

std::vector<exchange::UniversalMode> universal_modes(const model::System& system, const UniversalGeometry& geometry,
                                                     const modal::Modes& modes) {
  std::vector<exchange::UniversalMode> all;
  for (const modal::Mode& mode : modes.list) {
    exchange::UniversalMode written;
    written.ids = {foundation::shortened(mode.name, exchange::universal_id_width), "", "", "", ""};
    written.number = mode.number;
    exchange::UniversalNormalMode parameters;
    parameters.frequency_hz = mode.angular_frequency.value_or(0) / foundation::two_pi;
    parameters.modal_mass = mode.modal_mass;
    written.parameters = parameters;
    const auto add = [&](int label, const spatial::Vector6& motion) {
      exchange::UniversalNodeMotion node{label, {}};
      for (std::size_t j = 0; j < 6; ++j) node.components[j] = motion(to_index(j));
      written.nodes.push_back(node);
    };
    for (std::size_t b = 0; b < system.bodies().size(); ++b) {
      const model::Body& body = system.bodies()[b];
      const spatial::Vector6 at_pole = mode.shape.segment<6>(6 * to_index(b));
      const auto in_ground = [&](const Eigen::Vector3d& at) {
        const spatial::Vector6 moved = spatial::rigid_motion(at) * at_pole;
        spatial::Vector6 turned;
        turned << body.pose.rotation * moved.head<3>(), body.pose.rotation * moved.tail<3>();
        return turned;
      };
      add(geometry.label(body.name), in_ground(Eigen::Vector3d::Zero()));
      for (const auto& point : body.points) add(geometry.label(body.name + "." + point.name), in_ground(point.at));
      for (const model::Element& element : system.elements())
        for (const auto& [end, word] : {std::pair{&element.n, ".foot"}, std::pair{&element.k, ".head"}})
          if (end->body == b) add(geometry.label(element.name + word), in_ground(end->at));
    }
    all.push_back(std::move(written));
  }
  return all;
}

}  // namespace trivet::exports
