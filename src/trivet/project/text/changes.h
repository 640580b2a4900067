// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Applies `changes` to `base`, key by key. Single values and whole arrays replace the old ones, a component (at.y)
/// replaces one number of an array of three, and damping, inertia and orientation in braces replace the whole table.
/// Named parts (bodies, elements, excitations, …) must exist: a new one is a problem. `path` is the place of both in
/// the project.
void apply_changes(Node& base, const Node& changes, const std::string& path, foundation::Problems& problems);

/// True for tables whose keys exclude each other (damping, inertia, orientation): a new one in braces replaces the old
/// one.
[[nodiscard]] bool is_exclusive_table(const std::string& key);

/// The changes of a setting such as "elements.front.scale=1.5". A value that is not TOML is taken as text ("3 kg").
[[nodiscard]] foundation::Expected<Node> parse_setting(const std::string& setting);

/// The text of a project file with changes such as those of --set: numbers are replaced where they are written, in
/// their own unit, and a key that the text does not have is added to its table. All else stays: comments, order,
/// blanks. Rows of `[tables.…]` are found by their names. A value that the text does not hold is not changed; compare
/// the parsed result with what is wanted.
[[nodiscard]] std::string text_with_changes(std::string text, const std::vector<Node>& changes);

/// True if both have the same content, tables in any order and numbers in any unit, to round-off.
[[nodiscard]] bool same_numbers(const Node& a, const Node& b);

}  // namespace trivet::project
