// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

/// `[element_types.NAME]`: what equal elements share, written once (docs/project-file.md, "Element types").
namespace trivet::project {

/// The document with the keys of its type in every element that names one, in place of that name; nothing if it has no
/// types. An element keeps its place, and its scale multiplies that of its type. What both write is a problem that
/// names both places.
/// @param laws  built-in types, which no type may be called
[[nodiscard]] std::optional<Node> with_element_types(const Node& document, const std::vector<std::string>& laws,
                                                     foundation::Problems& problems);

/// Problems of keys that elements have from their type become problems of the type, and so does what the type lacks.
void name_element_types(const Node& document, foundation::Problems& problems);

}  // namespace trivet::project
