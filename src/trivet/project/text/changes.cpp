// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/changes.h"

#include <fmt/format.h>

#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/setting_words.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

bool holds_named_parts(const std::string& path) {
  return path == "bodies" || path == "nodes" || path == "elements" || path == "element_types" ||
      path == "excitations" || path == "relative" || path == "sections" || path == "clearances";
}

/// A whole constant force: a load case may have forces of its own.
bool is_constant_force(const std::string& path, const Node& change) {
  const Node* type = path == "excitations" ? change.find("type") : nullptr;
  return type && type->text == "constant" && change.find("on");
}

/// Frequencies of a response are a list or a band: a change of one takes the place of the other.
void drop_other_frequencies(Node& response, const Node& changes) {
  const auto drop = [&](std::string_view key) {
    for (std::size_t i = 0; i < response.keys.size(); ++i)
      if (response.keys[i] == key) {
        response.keys.erase(response.keys.begin() + static_cast<std::ptrdiff_t>(i));
        response.items.erase(response.items.begin() + static_cast<std::ptrdiff_t>(i));
        return;
      }
  };
  if (changes.find("at") && !changes.find("band"))
    for (const char* key : {"band", "points", "spacing"}) drop(key);
  if (changes.find("band") && !changes.find("at")) drop("at");
}

void refuse_new_name(const Node& base, const Node& change, const std::string& path, const std::string& key,
                     foundation::Problems& problems) {
  const std::string guess = foundation::nearest_name(key, base.keys);
  problems
      .error(path + "." + key, "the model has no such key or part",
             "cases and settings change what the model has; they add nothing",
             !guess.empty()          ? "did you mean \"" + guess + "\"?"
                 : base.keys.empty() ? "write it in the model, and change it here"
                                     : "known here: " + foundation::comma_separated(base.keys))
      .origin = change.origin;
}

/// at.y = … of at = [x, y, z].
void change_components(Node& array, const Node& changes, const std::string& path, foundation::Problems& problems) {
  for (std::size_t i = 0; i < changes.keys.size(); ++i) {
    const Node& change = changes.items[i];
    const std::string here = path + "." + changes.keys[i];
    const auto component = component_of(array, changes.keys[i]);
    if (component && change.kind != Node::Kind::table) {
      array.items[*component] = change;
      array.origin = change.origin;  // problems of the whole array are reported where it was last written
    } else if (component) {
      problems.error(here, "a longer path", "a component of an array is one number", "end the path at " + here).origin =
          change.origin;
    } else {
      const bool is_vector = component_of(array, "x").has_value();
      problems
          .error(
              here, is_vector ? "no such component" : fmt::format("an array of {}", array.items.size()),
              is_vector ? "its components are x, y and z" : "only arrays of three numbers have components: x, y and z",
              is_vector ? "name one of them" : "replace the whole array, or name a single number")
          .origin = change.origin;
    }
  }
}

}  // namespace

bool is_exclusive_table(const std::string& key) {
  return key == "damping" || key == "inertia" || key == "orientation" || key == "from_orientation";
}

void apply_changes(Node& base, const Node& changes, const std::string& path, foundation::Problems& problems) {
  if (path == "analyses.response") drop_other_frequencies(base, changes);
  for (std::size_t i = 0; i < changes.keys.size(); ++i) {
    const std::string& key = changes.keys[i];
    const Node& change = changes.items[i];
    const std::string here = path.empty() ? key : path + "." + key;
    if (path.empty() && key == "tables") {
      problems
          .error(here, "cannot be changed", "change its rows as elements, bodies and points",
                 "use their names: elements.\"NAME\".at.x")
          .origin = change.origin;
      continue;
    }
    if (path.empty() && (key == "cases" || key == "trivet")) {
      problems.error(here, "cannot be changed", "a case or a setting changes the model only", "remove it").origin =
          change.origin;
      continue;
    }
    Node* old = base.find(key);
    if (!old) {
      if (holds_named_parts(path) && !is_constant_force(path, change)) {
        refuse_new_name(base, change, path, key, problems);
      } else if (is_zero_by_default(key) && change.kind == Node::Kind::table) {
        Node zero = change;
        zero.kind = Node::Kind::array;
        zero.keys.clear();
        Node component;
        component.kind = Node::Kind::real;
        component.origin = change.origin;
        zero.items.assign(3, component);
        change_components(zero, change, here, problems);
        base.keys.push_back(key);
        base.items.push_back(std::move(zero));
      } else if (path.empty() && holds_named_parts(key) && change.kind == Node::Kind::table) {
        Node none = change;  // the model has no part of this kind
        none.keys.clear();
        none.items.clear();
        apply_changes(none, change, here, problems);
        base.keys.push_back(key);
        base.items.push_back(std::move(none));
      } else {
        base.keys.push_back(key);
        base.items.push_back(change);
      }
    } else if (old->kind == Node::Kind::table && change.kind == Node::Kind::table &&
               !(change.written_inline && is_exclusive_table(key))) {
      apply_changes(*old, change, here, problems);
    } else if (old->kind == Node::Kind::array && change.kind == Node::Kind::table) {
      change_components(*old, change, here, problems);
    } else {
      *old = change;
    }
  }
}

foundation::Expected<Node> parse_setting(const std::string& setting) {
  const std::string source = std::string(foundation::setting_source) + setting;
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    foundation::Problems problems;
    problems.error("", "no \"=\"", "a setting is KEY=VALUE", "for instance elements.front.scale=1.5").origin = {source,
                                                                                                                0, 0};
    return tl::make_unexpected(std::move(problems));
  }
  foundation::Expected<Node> plain = parse_toml(setting, source);
  if (!plain) {
    std::string quoted = "\"";
    for (const char c : setting.substr(equals + 1)) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
    const foundation::Expected<Node> as_text = parse_toml(setting.substr(0, equals + 1) + quoted + "\"", source);
    if (as_text) return as_text;
    for (auto& problem : plain.error().list())
      problem.remedy =
          "a setting is KEY=VALUE as in the file: write a name with blanks in quotes (elements.\"front "
          "left\".scale=2), and a number of an array of three as at.x, at.y, at.z";
  }
  return plain;
}

}  // namespace trivet::project
