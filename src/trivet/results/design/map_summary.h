// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/map/design_map.h"

namespace trivet::results {

/// Who reads words about a map: people have frequencies and levels of [display]; the words in JSON stay in the unit of
/// the band, and zero-to-peak.
enum class Readers { people, programs };

/// Findings at a mark, one sentence each: violated rules, then peaks, then the least margin.
[[nodiscard]] std::vector<std::string> verdict_words(const study::DesignMap& map, const study::MapMark& mark,
                                                     Readers readers = Readers::people);

/// The range of the rules: the band of the amplitudes, and the threshold for a peak.
[[nodiscard]] std::string criteria_words(const study::DesignMap& map);

/// A rule as the verdict names it: "m.z ≤ 0.5 mm", where `words` of the rule has SI units.
[[nodiscard]] std::string rule_words(const study::DesignMap& map, const design::MapRule& rule);

/// The feasible share of the map, and what may have been missed between designs.
[[nodiscard]] std::string feasible_words(const study::DesignMap& map);

/// The best design, or the nearest to feasible, with its margin. Empty if there is none.
[[nodiscard]] std::string best_words(const study::DesignMap& map);

/// Ends of the axes at which the best design is ("the upper end of δ"): a better one may lie beyond. Without ends at 0;
/// empty if the margin is 0 or unbounded.
[[nodiscard]] std::vector<std::string> best_ends(const study::DesignMap& map);

/// Rules that govern at least one design, that with most designs first.
[[nodiscard]] std::vector<std::size_t> governing_rules(const study::DesignMap& map);

/// Reason why no rule limits a design of this map: "no peak" or "no motion".
[[nodiscard]] std::string unlimited_words(const study::DesignMap& map);

/// Of designs without a result, in the key of a picture.
inline constexpr const char* not_computed_words = "not computed: unphysical body, or no model";

/// Warnings of the map, one sentence each.
[[nodiscard]] std::vector<std::string> doubts(const study::DesignMap& map);

}  // namespace trivet::results
