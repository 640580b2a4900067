// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "trivet/project/text/units.h"

namespace trivet::project {

/// A last word that should have been a level: "rmss".
struct LevelSlip {
  std::string rule;    ///< "\"rmss\" is no level; the levels are …"
  std::string remedy;  ///< "did you mean \"4.5 mm/s rms\"?"
};

/// The slip in a text of which all but the last word is a number with a unit of the quantity; none if it is another
/// text.
[[nodiscard]] std::optional<LevelSlip> level_slip(std::string_view text, Quantity quantity);

}  // namespace trivet::project
