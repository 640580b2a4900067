// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/length_between_ends.h"

#include <algorithm>

#include "trivet/project/text/table_reader.h"

namespace trivet::project {
namespace {

/// Place of an end in the ground frame; empty if it is not stated or cannot be read.
std::optional<Eigen::Vector3d> stated_place(TableReader& reader, const char* on, const char* at,
                                            const model::Description& description) {
  const Node* name = reader.node(on);
  const auto& bodies = description.bodies;
  const bool on_ground = !name || name->text == "ground";
  const auto body =
      std::ranges::find_if(bodies, [&](const model::Body& one) { return name && one.name == name->text; });
  if (!on_ground && body == bodies.end()) return std::nullopt;
  const bool node = !on_ground && body->is_node;
  if (!reader.has(at) && !node) return std::nullopt;
  auto place = reader.has(at) ? reader.vector(at, Quantity::length) : Eigen::Vector3d::Zero();
  if (!place || on_ground) return place;
  return body->pose.position + body->pose.rotation * *place;
}

}  // namespace

std::optional<Node> with_length_between_ends(const Node& element, const std::string& name,
                                             const model::Description& description) {
  const Node* type = element.kind == Node::Kind::table ? element.find("type") : nullptr;
  if (!type || element.find("length") || !element.find("on")) return std::nullopt;
  if (type->text != "beam" && type->text != "link" && type->text != "stay") return std::nullopt;
  foundation::Problems ignored;  // the reader of the element reports them
  TableReader reader(element, "elements." + name, ignored);
  const auto k = stated_place(reader, "on", "at", description),
             n = stated_place(reader, "from", "from_at", description);
  if (!k || !n) return std::nullopt;
  Node length;
  length.kind = Node::Kind::real;
  length.origin = element.origin;
  length.number = (*k - *n).norm();
  Node completed = element;
  completed.keys.push_back("length");
  completed.items.push_back(std::move(length));
  return completed;
}

}  // namespace trivet::project
