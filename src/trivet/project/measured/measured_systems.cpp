// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/measured_systems.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {
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
