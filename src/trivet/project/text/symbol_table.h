// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/model/system.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Names in the file, of readable and unreadable parts: a reference to an unreadable part is not a second problem.
struct SymbolTable {
  bool bodies_unknown = false;  ///< there is no readable table of bodies, or of nodes
  std::vector<std::string> bodies, nodes, points, elements, element_types, relative_motions, sections, clearances,
      harmonic_excitations, constant_excitations;
  std::vector<std::string> order_excitations, random_excitations,
      time_excitations;  ///< an unbalance drives harmonically and by orders
  struct FoundationReference {
    std::string element, ground;
    foundation::Origin origin;
  };
  std::vector<FoundationReference> foundation_references;             ///< elements and the foundations that they name
  std::vector<std::string> guided;                                    ///< "body.y": coordinates that do not move
  std::vector<std::function<void(model::Description&)>> adjustments;  ///< applied after all is read
};

/// Index of the body or node named at `key`, if it was read; an unknown name is a problem.
[[nodiscard]] std::optional<std::size_t> body_named(TableReader& reader, const std::string& key,
                                                    const model::Description& description, const SymbolTable& symbols);

/// Problems of names and texts that tables, pictures or file names cannot contain: control characters, and names too
/// long for file names.
[[nodiscard]] foundation::Problems check_names_and_texts(const Node& document);

}  // namespace trivet::project
