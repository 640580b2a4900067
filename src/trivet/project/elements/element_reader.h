// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/model/system.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/known_model.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {

/// The table of a beam, link or stay that states no `length`, completed by the distance between its ends. Empty if it
/// states a length, or if its ends are not both stated: end N is then placed by the length.
/// @param description  the bodies and nodes
[[nodiscard]] std::optional<Node> with_length_between_ends(const Node& element, const std::string& name,
                                                           const model::Description& description);

/// Reads the table `elements` into the description and reports its problems.
/// @param known  a model read earlier; unchanged elements between unchanged bodies are copied from it
void read_elements(TableReader& root, model::Description& description, SymbolTable& symbols,
                   const KnownModel* known = nullptr);

/// Built-in types of elements; "catalogue:NAME" stands for all mounts of catalogues.
[[nodiscard]] std::vector<std::string> element_law_names();

/// `damping` of the whole system.
void read_system_damping(TableReader& root, model::Description& description, SymbolTable& symbols);

}  // namespace trivet::project
