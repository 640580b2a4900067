// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/design_map.h"

namespace trivet::results {

/// What the rules are asked of: the band of the amplitudes, and what counts as a peak.
[[nodiscard]] std::string asked_words(const study::DesignMap& map);

/// How much of the map is feasible, and what of it may have been missed between designs.
[[nodiscard]] std::string feasible_words(const study::DesignMap& map);

/// The best design, or the nearest, with its margin. Empty if there is none.
[[nodiscard]] std::string best_words(const study::DesignMap& map);

/// Ends of the axes at which the best design stands ("the upper end of δ"): a better one may lie beyond. Not an end at
/// 0, and none where margins do not lead there.
[[nodiscard]] std::vector<std::string> best_ends(const study::DesignMap& map);

/// Rules that govern somewhere, that of most designs first.
[[nodiscard]] std::vector<std::size_t> governing_rules(const study::DesignMap& map);

/// Why no rule limits a design of this map: "no peak" or "nothing moves".
[[nodiscard]] std::string unlimited_words(const study::DesignMap& map);

}  // namespace trivet::results
