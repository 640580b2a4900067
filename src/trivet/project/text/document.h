// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

/// One value of a project file, with its place. Tables keep the order of the file.
struct Node {
  enum class Kind { table, array, text, integer, real, boolean, other };
  Kind kind = Kind::table;
  foundation::Origin origin;
  bool written_inline = false;    ///< a table in braces
  std::vector<std::string> keys;  ///< of a table, one per item
  std::vector<Node> items;        ///< of a table or array
  std::string text;
  std::string folder;  ///< of a text: in which it may name a file; empty: that of its source
  double number = 0;   ///< of an integer or real
  bool boolean = false;
  mutable std::optional<Quantity> quantity;  ///< of a number that TableReader has read

  [[nodiscard]] const Node* find(std::string_view key) const;
  [[nodiscard]] Node* find(std::string_view key);
};

[[nodiscard]] const char* kind_name(Node::Kind kind);

/// A value for a message: a number, true or false, or a text in quotes (shortened); else the kind of the value.
[[nodiscard]] std::string value_text(const Node& node);
/// One of several values for a message, in the unit of the file; the only one if there is no list.
[[nodiscard]] std::string value_text(const Node& node, std::size_t index);

/// True if both have the same content, at any place.
[[nodiscard]] bool same_content(const Node& a, const Node& b);

/// Text form of a value, equal for equal values.
[[nodiscard]] std::string canonical(const Node& node);

/// Deepest existing node on a path such as "elements.front spring.damping"; names in it may have dots.
[[nodiscard]] const Node& deepest(const Node& root, std::string_view path);

/// Sets missing origins of problems from their subject paths.
void locate(foundation::Problems& problems, const Node& root);

/// A text as a TOML string.
[[nodiscard]] std::string toml_string(const std::string& text);

/// A value as the project file has it, numbers by their shortest text of equal value: 1.5, "3 kN/m", [1, 2],
/// {loss_factor = 0.1}.
[[nodiscard]] std::string toml_value(const Node& node);

/// Changes as settings: "elements.\"front left\".scale = 1.5", one per value, with all digits.
[[nodiscard]] std::vector<std::string> setting_words(const std::vector<Node>& changes);

}  // namespace trivet::project
