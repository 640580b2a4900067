// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Each clearance of the model against how far its places approach: at rest, plus the largest harmonic amplitude in the
/// band of the requirements, plus the largest approach over the transient, if the file asks for one. Those that cannot
/// be computed have the reason. @param warnings  of the transient
[[nodiscard]] std::vector<RequirementResult> clearance_results(const CaseContext& context,
                                                               const project::Analyses& analyses,
                                                               foundation::Problems& warnings);

}  // namespace trivet::study
