// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/element_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

/// Keys of the element itself: its place, orientation, foundation, scale and acceptances.
constexpr std::array<const char*, 12> of_element = {"type",       "on",    "at",          "from",
                                                    "from_at",    "axis",  "orientation", "from_orientation",
                                                    "foundation", "scale", "accept",      "moved"};

bool is_of_element(const std::string& key) { return std::ranges::find(of_element, key) != of_element.end(); }

void set(Node& table, const std::string& key, Node value) {
  if (Node* old = table.find(key)) {
    *old = std::move(value);
    return;
  }
  table.keys.push_back(key);
  table.items.push_back(std::move(value));
}

/// The types of a file. An error of a type is reported once; its elements are still read.
class Types {
 public:
  Types(const Node& table, const std::vector<std::string>& laws, foundation::Problems& problems)
      : table_(table), problems_(problems) {
    for (std::size_t i = 0; i < table.keys.size(); ++i) check(table.keys[i], table.items[i], laws);
  }

  [[nodiscard]] bool has(const std::string& name) const {
    const Node* type = table_.find(name);
    return type && type->kind == Node::Kind::table;
  }

  /// The element with the keys of its type.
  [[nodiscard]] Node merged(const Node& element, const std::string& path, const std::string& type) const {
    const Node& shared = *table_.find(type);
    Node result = element;
    for (std::size_t i = 0; i < shared.keys.size(); ++i) {
      const std::string& key = shared.keys[i];
      if (key == "scale" || key == "damping_factor") multiply(result, key, shared.items[i]);
      if (key == "stiffness_factor") multiply_each(result, key, shared.items[i]);
      if (key == "type") set(result, key, shared.items[i]);
      if (is_of_element(key) || key.ends_with("_factor"))
        continue;  // keys of an element in a type are reported by check()
      if (const Node* own = element.find(key))
        problems_
            .error(path + "." + key, value_text(*own),
                   fmt::format("\"{}\" is fixed by its type \"{}\" ({})", key, type,
                               foundation::place(shared.items[i].origin)),
                   fmt::format("remove it here, change element_types.{}.{} for all its elements, or give this one "
                               "another type",
                               type, key))
            .origin = own->origin;
      set(result, key, shared.items[i]);
    }
    return result;
  }

 private:
  void check(const std::string& name, const Node& type, const std::vector<std::string>& laws) {
    const std::string path = "element_types." + name;
    if (type.kind != Node::Kind::table) {
      problems_
          .error(path, kind_name(type.kind), "an element type is a table",
                 "write [element_types.NAME] and what its elements share below")
          .origin = type.origin;
      return;
    }
    const bool built_in = std::ranges::find(laws, name) != laws.end() || name.starts_with("catalogue:");
    if (built_in)
      problems_.error(path, foundation::quoted(name), "a type of this name is built in", "choose another name").origin =
          type.origin;
    const Node* law = type.find("type");
    if (!law)
      problems_
          .error(path + ".type", "missing", "a type names the law of its elements", "type = \"bushing\", for instance")
          .origin = type.origin;
    else if (law->kind == Node::Kind::text && (law->text != name || !built_in) && table_.find(law->text))
      problems_
          .error(path + ".type", foundation::quoted(law->text), "a type names a law, not another type",
                 "write its keys here")
          .origin = law->origin;
    if (const Node* scale = type.find("scale"); scale && !(factor(*scale).value_or(0) > 0))
      problems_
          .error(path + ".scale", value_text(*scale), "a scale is a number > 0, or a text with a unit such as %",
                 "scale = 1.5, for instance")
          .origin = scale->origin;
    for (std::size_t i = 0; i < type.keys.size(); ++i)
      if (is_of_element(type.keys[i]) && type.keys[i] != "type" && type.keys[i] != "scale")
        problems_
            .error(path + "." + type.keys[i], value_text(type.items[i]),
                   fmt::format("\"{}\" belongs to each element, not to its type", type.keys[i]),
                   "write it in the elements")
            .origin = type.items[i].origin;
  }

  static std::optional<double> factor(const Node& scale) {
    if (scale.kind == Node::Kind::integer || scale.kind == Node::Kind::real) return scale.number;
    if (scale.kind != Node::Kind::text) return std::nullopt;
    const auto value = to_si(scale.text, Quantity::pure);
    return value ? std::optional(*value) : std::nullopt;
  }

  /// Multiplies the factors of element and type. check() reports a wrong scale of the type, the reader of the element
  /// the other errors.
  static void multiply(Node& element, const std::string& key, const Node& of_type) {
    Node* own = element.find(key);
    const auto shared = factor(of_type), mine = own ? factor(*own) : std::nullopt;
    if (!own && (key != "scale" || shared.value_or(0) > 0)) return set(element, key, of_type);
    if (!mine || !(shared.value_or(0) > 0)) return;
    own->number = *mine * *shared;
    own->kind = Node::Kind::real;
    own->text.clear();
  }

  static void multiply_each(Node& element, const std::string& key, const Node& of_type) {
    Node* own = element.find(key);
    if (!own || of_type.kind != Node::Kind::table) return set(element, key, of_type);
    if (own->kind != Node::Kind::table) return;
    for (std::size_t i = 0; i < of_type.keys.size(); ++i) multiply(*own, of_type.keys[i], of_type.items[i]);
  }

  const Node& table_;
  foundation::Problems& problems_;
};

/// True if the place is that of the node or of something inside it.
bool holds(const Node& node, const foundation::Origin& origin) {
  if (node.origin.line == origin.line && node.origin.column == origin.column && node.origin.source == origin.source)
    return true;
  return std::ranges::any_of(node.items, [&](const Node& item) { return holds(item, origin); });
}

/// The keys of "known here: …" that a type may have.
std::string without_keys_of_elements(const std::string& rule) {
  constexpr std::string_view start = "known here: ", between = ", ";
  std::string kept;
  for (std::size_t at = start.size(); rule.starts_with(start) && at < rule.size();) {
    const std::size_t end = std::min(rule.find(between, at), rule.size());
    const std::string key = rule.substr(at, end - at);
    if (!is_of_element(key) || key == "type" || key == "scale")
      kept += (kept.empty() ? std::string(start) : std::string(between)) + key;
    at = end + between.size();
  }
  return kept.empty() ? rule : kept;
}

/// Type of an element without a required key of its law.
std::optional<std::string> type_that_lacks(const Node& document, const Node& types, const std::string& subject,
                                           const std::string& finding) {
  if (finding != "missing") return std::nullopt;
  const std::size_t from = subject.find('.') + 1, to = subject.find('.', from);
  const std::string key = subject.substr(to + 1);
  const Node* elements = document.find("elements");
  const Node* element = elements ? elements->find(subject.substr(from, to - from)) : nullptr;
  const Node* type = element ? element->find("type") : nullptr;
  if (!type || type->kind != Node::Kind::text || is_of_element(key.substr(0, key.find('.'))) ||
      element->find(key.substr(0, key.find('.'))))
    return std::nullopt;
  return types.find(type->text) ? std::optional(type->text) : std::nullopt;
}

}  // namespace

std::optional<Node> with_element_types(const Node& document, const std::vector<std::string>& laws,
                                       foundation::Problems& problems) {
  const Node* table = document.find("element_types");
  if (!table) return std::nullopt;
  if (table->kind != Node::Kind::table) {
    problems.error("element_types", kind_name(table->kind), "element types are tables", "write [element_types.NAME]")
        .origin = table->origin;
    return std::nullopt;
  }
  Node result = document;
  const Types types(*table, laws, problems);
  std::vector<std::string> unused = table->keys;
  Node* elements = result.find("elements");
  for (std::size_t i = 0; elements && elements->kind == Node::Kind::table && i < elements->items.size(); ++i) {
    Node& element = elements->items[i];
    const Node* type = element.kind == Node::Kind::table ? element.find("type") : nullptr;
    if (!type || type->kind != Node::Kind::text || !types.has(type->text)) continue;
    std::erase(unused, type->text);
    element = types.merged(element, "elements." + elements->keys[i], std::string(type->text));
  }
  if (!elements || elements->keys.empty()) unused.clear();  // the missing elements are the problem
  for (const std::string& name : unused)
    problems
        .warning("element_types." + name, "no element is of this type", "a type acts only through its elements",
                 "name it in an element, type = \"" + name + "\", or remove it")
        .origin = table->find(name)->origin;
  return result;
}

void name_element_types(const Node& document, foundation::Problems& problems) {
  const Node* types = document.find("element_types");
  if (!types || types->kind != Node::Kind::table) return;
  for (foundation::Problem& problem : problems.list()) {
    constexpr std::string_view elements = "elements.";
    if (!problem.subject.starts_with(elements) || problem.origin.line == 0) continue;
    const std::size_t end_of_name = problem.subject.find('.', elements.size());
    if (end_of_name == std::string::npos) continue;
    if (const auto lacking = type_that_lacks(document, *types, problem.subject, problem.finding)) {
      problem.subject = "element_types." + *lacking + problem.subject.substr(end_of_name);
      problem.origin = types->find(*lacking)->origin;
      continue;
    }
    for (std::size_t i = 0; i < types->keys.size(); ++i)
      if (std::ranges::any_of(types->items[i].items, [&](const Node& item) { return holds(item, problem.origin); })) {
        problem.subject = "element_types." + types->keys[i] + problem.subject.substr(end_of_name);
        problem.rule = without_keys_of_elements(problem.rule);
        break;
      }
  }
}

}  // namespace trivet::project
