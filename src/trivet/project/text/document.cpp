// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/document.h"
#include "trivet/foundation/plain_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace trivet::project {

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
