// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Names that stand in the file, whether what they name could be read or not: a reference to an unreadable thing is no
/// second problem.
struct Mentioned {
  bool bodies_unknown = false;  ///< there is no readable table of bodies at all
  std::vector<std::string> bodies, points, elements, element_types, harmonic_excitations, constant_excitations;
  std::vector<std::string> order_excitations, random_excitations,
      time_excitations;  ///< an unbalance drives harmonically and by orders
  struct Standing {
    std::string element, ground;
    foundation::Origin origin;
  };
  std::vector<Standing> stands_on;                                    ///< elements and the foundations that they name
  std::vector<std::string> guided;                                    ///< "body.y": coordinates that do not move
  std::vector<std::function<void(model::Description&)>> adjustments;  ///< made when all has been read
};

/// A document that has been read already: what another one has in common with it need not be read again.
struct KnownModel {
  const Node& document;
  const model::Description& description;

  /// The thing of this name in a table ("bodies", "elements"), if both documents say the same of it and it has no
  /// adjustments, which are made in the description.
  [[nodiscard]] const Node* unchanged(const char* table, const std::string& name, const Node& now) const;
};

/// The body of that name, if it was read; a name that stands nowhere is a problem at `key`.
[[nodiscard]] std::optional<std::size_t> body_named(TableReader& reader, const std::string& key,
                                                    const model::Description& description, const Mentioned& mentioned);

}  // namespace trivet::project
