// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

/// Adds the isolation of forces from the ground, and of places from its motion: transmissibilities at a speed or over a
/// band, with the margin allowed / transmitted.
void add_isolation_requirements(const CaseContext& context, const project::Requirements& required,
                                RequirementList& list);

/// Sets value, place, margin and candidates of a requirement on a transmissibility.
/// @throws foundation::NotComputable, InvalidInput if the model does not have it
void judge_transmitted(const CaseContext& context, RequirementResult& result);

}  // namespace trivet::study
