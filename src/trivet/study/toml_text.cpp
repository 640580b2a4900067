// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/toml_text.h"

#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace trivet::study {
namespace {

constexpr int deepest_nesting = 64;

/// The parser builds one level of stack per bracket and per dot of a key: count them before it does.
int line_of_excessive_nesting(std::string_view text) {
  int line = 1, brackets = 0, dots = 0;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') brackets = std::max(0, brackets - 1);
    if (c == '.') ++dots;
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == ']' || c == '{' || c == '}') dots = 0;
    if (brackets > deepest_nesting || dots > deepest_nesting) return line;
  }
  return 0;
}

foundation::Origin origin_of(const toml::source_region& region, const std::string& source) {
  return {source, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Node converted(const toml::node& from, const std::string& source) {
  Node node;
  node.origin = origin_of(from.source(), source);
  if (const auto* table = from.as_table()) {
    node.kind = Node::Kind::table;
    node.written_inline = table->is_inline();
    for (const auto& [key, value] : *table) {
      node.keys.emplace_back(key.str());
      node.items.push_back(converted(value, source));
      Node& item = node.items.back();
      if (item.origin.line == 0 && key.source().begin.line > 0) item.origin = origin_of(key.source(), source);
    }
    // The parser sorts by name; a project file means the order of its lines.
    std::vector<std::size_t> order(node.keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto place = [&](std::size_t i) { return std::make_pair(node.items[i].origin.line, node.items[i].origin.column); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    Node sorted = node;
    for (std::size_t i = 0; i < order.size(); ++i) {
      sorted.keys[i] = node.keys[order[i]];
      sorted.items[i] = std::move(node.items[order[i]]);
    }
    return sorted;
  }
  if (const auto* array = from.as_array()) {
    node.kind = Node::Kind::array;
    for (const auto& value : *array) node.items.push_back(converted(value, source));
  } else if (const auto* text = from.as_string()) {
    node.kind = Node::Kind::text;
    node.text = text->get();
  } else if (const auto* integer = from.as_integer()) {
    node.kind = Node::Kind::integer;
    node.number = static_cast<double>(integer->get());
  } else if (const auto* real = from.as_floating_point()) {
    node.kind = Node::Kind::real;
    node.number = real->get();
  } else if (const auto* boolean = from.as_boolean()) {
    node.kind = Node::Kind::boolean;
    node.boolean = boolean->get();
  } else {
    node.kind = Node::Kind::other;
  }
  return node;
}

tl::unexpected<foundation::Problems> refused(foundation::Origin origin, std::string finding, std::string rule, std::string remedy) {
  foundation::Problems problems;
  problems.error("", std::move(finding), std::move(rule), std::move(remedy)).origin = std::move(origin);
  return tl::make_unexpected(std::move(problems));
}

}  // namespace

foundation::Expected<Node> parse_toml(std::string_view text, const std::string& source) {
  if (const int line = line_of_excessive_nesting(text))
    return refused({source, line, 0}, "more than 64 levels of brackets or dots", "a project file is a few levels deep", "look for a missing closing bracket");
  try {
    const toml::table table = toml::parse(text, std::string_view(source));
    Node root = converted(table, source);
    root.origin = {source, 0, 0};
    return root;
  } catch (const toml::parse_error& error) {
    return refused(origin_of(error.source(), source), std::string(error.description()), "the file must be valid TOML",
                   "mend this line (strings in quotes, one value per key, arrays in square brackets)");
  }
}

}  // namespace trivet::study
