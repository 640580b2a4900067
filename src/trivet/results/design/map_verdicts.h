// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/map/design_map.h"

namespace trivet::results {

/// Findings at a mark, one sentence each: violated rules, then peaks, then the least margin.
[[nodiscard]] std::vector<std::string> verdict_words(const study::DesignMap& map, const study::MapMark& mark);

}  // namespace trivet::results
