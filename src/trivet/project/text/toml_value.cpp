// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/toml_value.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {
namespace {

std::string number_text(const Node& node) {
  if (std::isnan(node.number)) return "nan";
  if (std::isinf(node.number)) return node.number > 0 ? "inf" : "-inf";
  if (node.kind == Node::Kind::integer) return fmt::format("{:.0f}", node.number);
  return fmt::format("{}", node.number);
}

void list_settings(const Node& node, const std::string& path, std::vector<std::string>& settings) {
  if (node.kind != Node::Kind::table || node.written_inline) {
    settings.push_back(path + " = " + toml_value(node));
    return;
  }
  for (std::size_t i = 0; i < node.keys.size(); ++i)
    list_settings(node.items[i], (path.empty() ? "" : path + ".") + foundation::path_key(node.keys[i]), settings);
}

}  // namespace

std::string toml_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) quoted += fmt::format("\\u{:04x}", static_cast<int>(c));
    else quoted += c;
  }
  return quoted + "\"";
}

std::string toml_value(const Node& node) {
  std::string text;
  switch (node.kind) {
    case Node::Kind::table:
      for (std::size_t i = 0; i < node.keys.size(); ++i)
        text += (i > 0 ? ", " : "") + foundation::path_key(node.keys[i]) + " = " + toml_value(node.items[i]);
      return "{" + text + "}";
    case Node::Kind::array:
      for (std::size_t i = 0; i < node.items.size(); ++i) text += (i > 0 ? ", " : "") + toml_value(node.items[i]);
      return "[" + text + "]";
    case Node::Kind::boolean:
      return node.boolean ? "true" : "false";
    case Node::Kind::integer:
    case Node::Kind::real:
      return number_text(node);
    default:
      return toml_string(node.text);
  }
}

std::vector<std::string> setting_words(const std::vector<Node>& changes) {
  std::vector<std::string> settings;
  for (const Node& change : changes) list_settings(change, "", settings);
  return settings;
}

}  // namespace trivet::project
