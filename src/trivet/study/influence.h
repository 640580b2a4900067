// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// What the two numbers of a map do to the answers of its rules, seen at 3 × 3 designs and three frequencies of each.
struct Influence {
  std::vector<std::string> still;  ///< answers that are zero but for round-off in all of these
  bool by_x = true, by_y = true;   ///< false: no answer changes its amplitude along this axis
};

/// Says nothing where one of these designs has no model or no answer.
[[nodiscard]] Influence influence(const project::Case& variant, const project::MapRequest& request,
                                  const std::vector<design::MapRule>& rules);

}  // namespace trivet::study
