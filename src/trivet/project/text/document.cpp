// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/units.h"

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

const Node* Node::find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (keys[i] == key) return &items[i];
  return nullptr;
}

Node* Node::find(std::string_view key) { return const_cast<Node*>(std::as_const(*this).find(key)); }

const char* kind_name(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::table:
      return "a table";
    case Node::Kind::array:
      return "an array";
    case Node::Kind::text:
      return "a text";
    case Node::Kind::integer:
      return "an integer";
    case Node::Kind::real:
      return "a number";
    case Node::Kind::boolean:
      return "true or false";
    case Node::Kind::other:
      return "a date or time";
  }
  return "";
}

std::string value_text(const Node& node) {
  switch (node.kind) {
    case Node::Kind::text:
      return foundation::quoted(node.text);
    case Node::Kind::integer:
    case Node::Kind::real:
      return fmt::format("{:.9g}", node.number);
    case Node::Kind::boolean:
      return node.boolean ? "true" : "false";
    default:
      return kind_name(node.kind);
  }
}

std::string value_text(const Node& node, std::size_t index) {
  const Node& value = index < node.items.size() ? node.items[index] : node;
  const bool bare = value.kind == Node::Kind::integer || value.kind == Node::Kind::real;
  if (!bare || value.quantity.value_or(Quantity::pure) == Quantity::pure) return value_text(value);
  return fmt::format("{} {}", value_text(value), printed_si_unit(*value.quantity));
}

std::string canonical(const Node& node) {
  switch (node.kind) {
    case Node::Kind::text:
      return "\"" + node.text + "\"";
    case Node::Kind::integer:
    case Node::Kind::real:
      return fmt::format("{:.17g}", node.number);
    case Node::Kind::boolean:
      return node.boolean ? "true" : "false";
    default:
      break;
  }
  std::string text = "{";
  for (std::size_t i = 0; i < node.items.size(); ++i)
    text += (node.kind == Node::Kind::table ? node.keys[i] + "=" : std::string()) + canonical(node.items[i]) + ";";
  return text + "}";
}

const Node& deepest(const Node& root, std::string_view path) {
  const Node* node = &root;
  while (!path.empty()) {
    const Node* next = nullptr;
    std::size_t end = path.size();  // the longest name that matches: names may have dots
    for (;;) {
      next = node->find(path.substr(0, end));
      if (next || end == 0) break;
      const std::size_t dot = path.rfind('.', end - 1);
      if (dot == std::string_view::npos) break;
      end = dot;
    }
    if (!next) break;
    node = next;
    path = end == path.size() ? std::string_view() : path.substr(end + 1);
  }
  return *node;
}

void locate(foundation::Problems& problems, const Node& root) {
  for (foundation::Problem& problem : problems.list())
    if (problem.origin.source.empty()) {
      problem.origin = deepest(root, problem.subject).origin;
      if (problem.origin.source.empty()) problem.origin.source = root.origin.source;
    }
}

bool same_content(const Node& a, const Node& b) {
  return a.kind == b.kind && a.number == b.number && a.boolean == b.boolean && a.text == b.text && a.keys == b.keys &&
      std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), same_content);
}

}  // namespace trivet::project
