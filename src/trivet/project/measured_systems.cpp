// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured_systems.h"

#include <algorithm>
#include <iterator>
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
    if ((node.definition_system != 0 || node.displacement_system != 0) && measured.contains(node.label))
      nodes.push_back(node);
  return nodes;
}

foundation::Problems judge_directions(const std::vector<UniversalNode>& nodes) {
  std::vector<UniversalNode> turned;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(turned),
               [](const UniversalNode& node) { return node.displacement_system != 0; });
  foundation::Problems found;
  if (!turned.empty())
    found.warning("", "set 15 gives displacements of the nodes " + labels_of(turned) + " in a coordinate system not 0",
                  "coordinate systems of the file are not applied",
                  "their directions are read as axes of the ground; check that they are");
  return found;
}

foundation::Problems judge_positions(const std::vector<UniversalNode>& nodes) {
  foundation::Problems found;
  if (!nodes.empty())
    found.warning("", "set 15 has the nodes " + labels_of(nodes) + " in a coordinate system not 0",
                  "coordinate systems of the file are not applied: such a node has no place by its position",
                  "add nodes = {\"" + std::to_string(nodes.front().label) + "\" = \"BODY.POINT\"}");
  return found;
}

}  // namespace trivet::project
