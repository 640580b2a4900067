// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/model/system.h"

namespace trivet::model {

/// Name of the first element that is mounted on the modes of a foundation. A rigid motion of the whole ground cannot be
/// applied to it: the data do not state the participation of the modes in such a motion.
[[nodiscard]] inline std::optional<std::string> element_on_modes(const Description& description) {
  for (const Element& element : description.elements) {
    if (element.is_foundation || !element.n.foundation) continue;
    bool has_place_of_its_own = false;
    for (const Element& other : description.elements)
      has_place_of_its_own = has_place_of_its_own ||
          (joins_foundation_to_ground(other) && other.k.foundation->foundation == element.n.foundation->foundation);
    if (!has_place_of_its_own) return element.name;
  }
  return std::nullopt;
}

}  // namespace trivet::model
