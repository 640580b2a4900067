// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/toml_text.h"

#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "trivet/project/text/source_file.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {
namespace {

constexpr int deepest_nesting = 64;

/// Line with too many brackets or dots, or 0. The parser needs one level of stack for each, so they are counted first.
int line_of_excessive_nesting(std::string_view text) {
  int brackets = 0, dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const std::size_t end = after_comment_or_string(text, i); end > i) {
      i = end - 1;
      continue;
    }
    const char c = text[i];
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') brackets = std::max(0, brackets - 1);
    if (c == '.') ++dots;
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == ']' || c == '{' || c == '}') dots = 0;
    if (brackets > deepest_nesting || dots > deepest_nesting)
      return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n'));
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
    // The parser sorts by name; the order of the lines is restored.
    std::vector<std::size_t> order(node.keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto place = [&](std::size_t i) {
      return std::make_pair(node.items[i].origin.line, node.items[i].origin.column);
    };
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    std::vector<std::string> keys;
    std::vector<Node> items;
    for (const std::size_t i : order) {
      keys.push_back(std::move(node.keys[i]));
      items.push_back(std::move(node.items[i]));
    }
    node.keys = std::move(keys);
    node.items = std::move(items);
    return node;
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

/// Index of the byte of a column that is counted in characters.
std::size_t byte_of(std::string_view line, unsigned column) {
  std::size_t at = 0;
  const auto begins = [&] { return (static_cast<unsigned char>(line[at]) & 0xC0) != 0x80; };
  for (unsigned c = 0; at < line.size() && (c += begins()) < column;) ++at;
  return at;
}

/// Key as written whose value starts at a place, or the name in a header that starts there.
std::string key_around(std::string_view text, const toml::source_position& place) {
  for (unsigned l = 1; l < place.line; ++l) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  const std::string_view line = text.substr(0, text.find('\n'));
  const std::size_t at = byte_of(line, place.column);
  std::size_t start = 0, key_start = at, key_end = at;
  for (std::size_t i = 0; i < at; i = std::max(i + 1, after_comment_or_string(line, i))) {
    if (line[i] == '{' || line[i] == ',' || line[i] == '[') start = i + 1;
    if (line[i] == '=') key_start = start, key_end = i;
  }
  if (key_end == at)  // a header
    while (key_end < line.size() && line[key_end] != ']')
      key_end = std::max(key_end + 1, after_comment_or_string(line, key_end));
  const std::string_view key = line.substr(key_start, key_end - key_start);
  const std::size_t first = key.find_first_not_of(" \t["), last = key.find_last_not_of(" \t");
  return first == std::string_view::npos ? "" : std::string(key.substr(first, last + 1 - first));
}

/// The parser repeats letters of a quoted key that appears twice, so the key is taken from the text.
std::string finding_of(const toml::parse_error& error, std::string_view text) {
  std::string finding(error.description());
  const std::size_t begin = finding.find('\''), end = finding.rfind('\'');
  const std::string key = key_around(text, error.source().begin);
  if (finding.find("cannot redefine existing") == std::string::npos || begin == end || key.empty()) return finding;
  if (end + 1 == finding.size()) return key + " appears twice";
  return finding.substr(0, begin) + key + finding.substr(end + 1);
}

tl::unexpected<foundation::Problems> refused(foundation::Origin origin, std::string finding, std::string rule,
                                             std::string remedy) {
  return foundation::failure({.origin = std::move(origin),
                              .finding = std::move(finding),
                              .rule = std::move(rule),
                              .remedy = std::move(remedy)});
}

}  // namespace

foundation::Expected<Node> parse_toml(std::string_view text, const std::string& source) {
  if (foundation::Problems foreign = encoding_problems(text, source); foreign.has_errors())
    return tl::make_unexpected(std::move(foreign));
  if (const int line = line_of_excessive_nesting(text))
    return refused({source, line, 0}, "more than 64 levels of brackets or dots", "a project file is a few levels deep",
                   "look for a missing closing bracket");
  try {
    const toml::table table = toml::parse(text, std::string_view(source));
    Node root = converted(table, source);
    root.origin = {source, 0, 0};
    foundation::Problems unprintable = check_names_and_texts(root);
    if (unprintable.has_errors()) return tl::make_unexpected(std::move(unprintable));
    return root;
  } catch (const toml::parse_error& error) {
    const std::string finding = finding_of(error, text);
    return refused(origin_of(error.source(), source), finding, "the file must be valid TOML",
                   finding.find("control characters") != std::string::npos
                       ? "look for a missing closing quote"
                       : "correct this line (strings and numbers with a unit in quotes, one value per key, arrays in "
                         "square brackets)");
  }
}

}  // namespace trivet::project
