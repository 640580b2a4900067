// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Values and margins of all requirements of a case: of [requirements], [limits] and [limit_lines].
[[nodiscard]] std::vector<RequirementResult> requirement_values(const CaseContext& context,
                                                                const project::Analyses& analyses,
                                                                foundation::Problems& warnings);

}  // namespace trivet::study
