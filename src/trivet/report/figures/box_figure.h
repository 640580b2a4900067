// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/report/drawing/figures.h"
#include "trivet/study/box/solution_box.h"

namespace trivet::report {

/// The range of each tolerance as a bar, over its tolerance in the file: ends with their deviations and what stops
/// them.
[[nodiscard]] Figure box_figure(const study::SolutionBox& box, const std::string& title);

}  // namespace trivet::report
