// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// Effect of the two numbers of a map on the answers of its rules, from 3 × 3 designs at three frequencies each.
struct AxisEffects {
  std::vector<std::string> zero_answers;  ///< answers that are zero except for round-off in all of them
  bool by_x = true, by_y = true;          ///< false: no answer changes its amplitude along this axis
};

/// Reports no findings if one of these designs has no model or no answer.
[[nodiscard]] AxisEffects axis_effects(const project::Case& variant, const project::MapRequest& request,
                                       const std::vector<design::MapRule>& rules);

}  // namespace trivet::study
