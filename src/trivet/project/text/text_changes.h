// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// The text of a project file with changes such as those of --set: numbers are replaced where they are written, in
/// their own unit, and a key that the text does not have is added to its table. All else stays: comments, order,
/// blanks. Rows of `[tables.…]` are found by their names. A value that the text does not hold is not changed; compare
/// the parsed result with what is wanted.
[[nodiscard]] std::string text_with_changes(std::string text, const std::vector<Node>& changes);

/// True if both have the same content, tables in any order and numbers in any unit, to round-off.
[[nodiscard]] bool same_numbers(const Node& a, const Node& b);

}  // namespace trivet::project
