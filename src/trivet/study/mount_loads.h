// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/case_context.h"
#include "trivet/study/verdict.h"

namespace trivet::study {

/// Static force of each catalogue mount along its axis, and its deflection, against the ranges of its maker.
[[nodiscard]] std::vector<RequirementResult> mount_loads(const CaseContext& context);

}  // namespace trivet::study
