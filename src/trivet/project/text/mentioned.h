// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
  std::vector<std::string> bodies, points, elements, harmonic_excitations, constant_excitations;
  std::vector<std::string> order_excitations, random_excitations, time_excitations;  ///< an unbalance drives harmonically and by orders
  struct Standing {
    std::string element, ground;
    foundation::Origin origin;
  };
  std::vector<Standing> stands_on;  ///< elements and the foundations that they name
  std::vector<std::string> guided;  ///< "body.y": coordinates that do not move
};

/// The body of that name, if it was read; a name that stands nowhere is a problem at `key`.
[[nodiscard]] std::optional<std::size_t> body_named(TableReader& reader, const std::string& key, const model::Description& description,
                                                    const Mentioned& mentioned);

}  // namespace trivet::project
