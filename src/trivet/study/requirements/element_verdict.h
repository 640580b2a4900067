// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/model/system.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Of the requirements on an element (a mount's load and deflections) and on its results (its forces, its
/// deflections), the one with the least margin. In the order of the elements; those that nothing judges are absent.
[[nodiscard]] std::vector<ElementVerdict> element_verdicts(const model::System& system,
                                                           const std::vector<RequirementResult>& results);

}  // namespace trivet::study
