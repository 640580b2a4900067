// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::project {

/// One value of a project file, with where it stands. Tables keep the order of the file.
struct Node {
  enum class Kind { table, array, text, integer, real, boolean, other };
  Kind kind = Kind::table;
  foundation::Origin origin;
  bool written_inline = false;    ///< a table in braces
  std::vector<std::string> keys;  ///< of a table, one per item
  std::vector<Node> items;        ///< of a table or array
  std::string text;
  double number = 0;  ///< of an integer or real
  bool boolean = false;

  [[nodiscard]] const Node* find(std::string_view key) const;
  [[nodiscard]] Node* find(std::string_view key);
};

[[nodiscard]] const char* words(Node::Kind kind);

/// A value for a message: numbers as such, texts in quotes, shortened; the kind of what is neither.
[[nodiscard]] std::string shown(const Node& node);

/// Do both say the same, wherever they stand?
[[nodiscard]] bool same_content(const Node& a, const Node& b);

/// The value written out, equal for equal values.
[[nodiscard]] std::string canonical(const Node& node);

/// "elements.front spring.damping" → the deepest node on that path that exists.
[[nodiscard]] const Node& deepest(const Node& root, std::string_view path);

/// Sets the origin of every problem that has none from its subject path.
void locate(foundation::Problems& problems, const Node& root);

}  // namespace trivet::project
