// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/symbol_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {

std::optional<std::size_t> body_named(TableReader& reader, const std::string& key,
                                      const model::Description& description, const SymbolTable& symbols) {
  const auto name = reader.text(key);
  if (!name) return std::nullopt;
  for (std::size_t i = 0; i < description.bodies.size(); ++i)
    if (description.bodies[i].name == *name) return i;
  std::vector<std::string> known = symbols.bodies;
  known.insert(known.end(), symbols.nodes.begin(), symbols.nodes.end());
  if (symbols.bodies_unknown || std::ranges::find(known, *name) != known.end()) return std::nullopt;
  const std::string guess = foundation::nearest_name(*name, known);
  const bool nodes = !symbols.nodes.empty();
  reader.error(key, foundation::quoted(*name), nodes ? "no body or node has this name" : "no body has this name",
               guess.empty()
                   ? (nodes ? "the bodies and nodes are: " : "the bodies are: ") + foundation::comma_separated(known)
                   : "did you mean \"" + guess + "\"?");
  return std::nullopt;
}

namespace {

constexpr std::size_t longest_name =
    100;  // [bytes] of a part: case names become folders, and file systems allow 255 bytes
constexpr std::size_t longest_key = 330;    // "BODY.POINT.rx", "ELEMENT.force.x" of names as long as may be
constexpr std::size_t longest_text = 4096;  // a path on Linux

bool holds_names(const std::string& path) {
  constexpr std::array<const char*, 11> tables = {"bodies",      "nodes",       "elements",    "excitations",
                                                  "foundations", "relative",    "sections",    "clearances",
                                                  "cases",       "limit_lines", "measurements"};
  return std::ranges::find(tables, path) != tables.end() || (path.starts_with("bodies.") && path.ends_with(".points"));
}

void check_key(const std::string& path, const std::string& key, const foundation::Origin& origin,
               foundation::Problems& problems) {
  const std::string where = (path.empty() ? "" : path + ".") + foundation::shortened(key);
  const std::size_t most = holds_names(path) ? longest_name : longest_key;
  if (const auto found = foundation::unprintable(key))
    problems
        .error(where, *found, "a name is printed in tables, pictures and file names: one line of printable characters",
               "remove it from the name")
        .origin = origin;
  if (key.size() > most)
    problems
        .error(where, fmt::format("a name of {} bytes", key.size()),
               fmt::format("at most {} bytes are allowed: file names contain it", most), "shorten it")
        .origin = origin;
}

void check_names(const Node& node, const std::string& path, foundation::Problems& problems) {
  if (node.kind == Node::Kind::text) {
    if (const auto found = foundation::unprintable(node.text, false))
      problems.error(path, *found, "a text holds printable characters, blanks and line breaks", "remove it").origin =
          node.origin;
    if (node.text.size() > longest_text)
      problems
          .error(path, fmt::format("a text of {} bytes", node.text.size()),
                 fmt::format("at most {} bytes are allowed", longest_text), "shorten it")
          .origin = node.origin;
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const bool table = node.kind == Node::Kind::table;
    if (table) check_key(path, node.keys[i], node.items[i].origin, problems);
    if (node.items[i].kind == Node::Kind::integer || node.items[i].kind == Node::Kind::real) continue;
    check_names(node.items[i],
                !table             ? path
                    : path.empty() ? node.keys[i]
                                   : path + "." + foundation::shortened(node.keys[i]),
                problems);
  }
}

}  // namespace

foundation::Problems check_names_and_texts(const Node& document) {
  foundation::Problems problems;
  check_names(document, "", problems);
  return problems;
}

}  // namespace trivet::project
