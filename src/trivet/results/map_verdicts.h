// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/design_map.h"

namespace trivet::study {

/// What was found at a mark, one sentence each: broken rules, then peaks, then the least margin.
[[nodiscard]] std::vector<std::string> verdict_words(const DesignMap& map, const MapMark& mark);

}  // namespace trivet::study
