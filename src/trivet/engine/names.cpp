// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/names.h"

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/text/model_path.h"

namespace trivet::engine {

std::vector<std::string> result_names(const Session& session) {
  const model::Description& description = session.model().system.description();
  project::SymbolTable symbols;
  for (const model::Body& body : description.bodies) {
    (body.is_node ? symbols.nodes : symbols.bodies).push_back(body.name);
    for (const model::Point& point : body.points) symbols.points.push_back(body.name + "." + point.name);
  }
  for (const model::Element& element : description.elements)
    if (!element.is_foundation) symbols.elements.push_back(element.name);
  for (const model::RelativeMotion& motion : description.relative_motions)
    symbols.relative_motions.push_back(motion.name);
  const project::ResultNames known(symbols);
  std::vector<std::string> names = known.groups();
  for (std::string& one : known.components()) names.push_back(std::move(one));
  return names;
}

namespace {

void add_numbers(const project::Node& node, const std::string& path, std::vector<std::string>& paths) {
  using Kind = project::Node::Kind;
  if (node.kind == Kind::table) {
    for (std::size_t i = 0; i < node.keys.size(); ++i)
      add_numbers(node.items[i], (path.empty() ? "" : path + ".") + foundation::path_key(node.keys[i]), paths);
  } else if (project::component_of(node, "x")) {
    for (const char* component : {".x", ".y", ".z"}) paths.push_back(path + component);
  } else if (node.kind == Kind::array || project::written_number(node)) {
    paths.push_back(path);
  }
}

}  // namespace

std::vector<std::string> number_paths(const Session& session) {
  std::vector<std::string> paths;
  add_numbers(session.model().document, "", paths);
  return paths;
}

}  // namespace trivet::engine
