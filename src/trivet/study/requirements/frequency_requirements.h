// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

/// Adds what concerns free vibration, with values and margins: natural frequencies, damping ratios, decoupling.
void add_frequency_requirements(const CaseContext& context, const project::Requirements& required,
                                RequirementList& list);

}  // namespace trivet::study
