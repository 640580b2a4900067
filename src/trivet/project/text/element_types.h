// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

/// `[element_types.NAME]`: properties that equal elements share (docs/project-file.md, "Element types").
namespace trivet::project {

/// The document with the keys of the type merged into every element that names one; none if it has no types. An element
/// keeps its place, and its scale multiplies that of its type. A key in both is a problem that names both places.
/// @param laws  built-in types, whose names are reserved
[[nodiscard]] std::optional<Node> with_element_types(const Node& document, const std::vector<std::string>& laws,
                                                     foundation::Problems& problems);

/// Moves problems of keys that come from a type, or are missing in it, from the elements to the type.
void name_element_types(const Node& document, foundation::Problems& problems);

}  // namespace trivet::project
