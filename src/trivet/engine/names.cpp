// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/names.h"

#include <algorithm>

#include "trivet/assembly/channels.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/model_path.h"

namespace trivet::engine {

std::string shell_word(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char one : text) quoted += one == '\'' ? std::string("'\\''") : std::string(1, one);
  return quoted + "'";
}

std::string project_word(const project::Project& project) {
  return project.source == standard_input ? "-" : shell_word(project.source);
}

std::vector<std::string> result_names(const Session& session) {
  const model::System& system = session.model().system;
  std::vector<std::string> names = assembly::channel_words(system.description());
  for (const model::Element& element : system.description().elements)  // a file cannot name those of a foundation
    if (element.is_foundation)
      for (const char* end : {"", ".deflection", ".foot"}) std::erase(names, element.name + end);
  const std::vector<std::string> groups = names;
  for (const assembly::Channel& channel :
       assembly::channels(system, assembly::assemble(system), groups, assembly::MotionQuantity::displacement))
    names.push_back(channel.name);
  return names;
}

namespace {

bool is_of_numbers(const project::Node& node) {
  if (node.kind == project::Node::Kind::array)
    return !node.items.empty() && std::ranges::all_of(node.items, is_of_numbers);
  return project::written_number(node).has_value();
}

void add_numbers(const project::Node& node, const std::string& path, std::vector<std::string>& paths) {
  if (node.kind == project::Node::Kind::table) {
    for (std::size_t i = 0; i < node.keys.size(); ++i)
      add_numbers(node.items[i], (path.empty() ? "" : path + ".") + foundation::path_key(node.keys[i]), paths);
  } else if (!is_of_numbers(node)) {
    return;
  } else if (project::component_of(node, "x")) {
    for (const char* component : {".x", ".y", ".z"}) paths.push_back(path + component);
  } else {
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
