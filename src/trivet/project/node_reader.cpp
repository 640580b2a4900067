// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/node_reader.h"

#include <fmt/format.h>

#include "trivet/project/body_reader.h"

namespace trivet::project {
namespace {

/// As many as bodies.
constexpr std::size_t most_nodes = 200;

model::Body read_node(const Node& node, const std::string& name, NamesInFile& in_file, foundation::Problems& problems) {
  TableReader reader(node, "nodes." + name, problems);
  model::Body body;
  body.name = name;
  body.is_node = true;
  body.mass.mass = 0;
  body.mass.centre.setZero();
  body.mass.inertia_about_centre.setZero();
  body.pose.position = reader.vector("position", Quantity::length).value_or(Eigen::Vector3d::Zero());
  if (!reader.has("position")) reader.missing("position", "give its place in the ground frame: position = [x, y, z]");
  body.pose.rotation = reader.orientation("orientation").value_or(Eigen::Matrix3d::Identity());
  read_free(reader, body, in_file);
  for (const char* key : {"mass", "inertia", "center_of_mass", "solids", "points"}) {
    if (!reader.has(key)) continue;
    reader.error(key, "unknown key", "a node has no mass and is one place: position, orientation and free",
                 "describe a part with mass or several points as a body: [bodies.NAME]");
    static_cast<void>(reader.node(key));
  }
  reader.finish();
  return body;
}

}  // namespace

void read_nodes(TableReader& root, model::Description& description, NamesInFile& in_file) {
  const Node* table = root.table("nodes");
  if (!table) {
    in_file.bodies_unknown = in_file.bodies_unknown || root.has("nodes");
    return;
  }
  if (table->keys.size() > most_nodes)
    root.error("nodes", fmt::format("{} nodes", table->keys.size()),
               fmt::format("this version takes at most {}", most_nodes), "split the model");
  in_file.nodes = table->keys;
  for (std::size_t i = 0; i < table->keys.size() && i < most_nodes; ++i)
    if (table->items[i].kind == Node::Kind::table)
      description.bodies.push_back(read_node(table->items[i], table->keys[i], in_file, root.problems()));
    else
      root.problems()
          .error("nodes." + table->keys[i], kind_name(table->items[i].kind), "a node is a table",
                 "write [nodes.NAME] and its position below")
          .origin = table->items[i].origin;
}

}  // namespace trivet::project
