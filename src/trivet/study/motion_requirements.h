// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/case_context.h"
#include "trivet/study/requirement_list.h"

namespace trivet::study {

/// Adds bounds of motions and forces at rest, in random vibration and in a transient, with values and margins.
/// @param warnings  of the transient
void add_motion_requirements(const CaseContext& context, const project::Analyses& analyses,
                             foundation::Problems& warnings, RequirementList& list);

}  // namespace trivet::study
