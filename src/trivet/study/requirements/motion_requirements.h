// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

/// Adds bounds of motions and forces at rest, in random vibration and in a transient, with values and margins.
/// @param warnings  of the transient
void add_motion_requirements(const CaseContext& context, const project::Analyses& analyses,
                             foundation::Problems& warnings, RequirementList& list);

/// Sets the largest displacements over the transient, from result `first` of the list on.
void set_largest(const CaseContext& context, const project::Analyses& analyses, foundation::Problems& warnings,
                 std::size_t first, const std::vector<project::AmplitudeLimit>& limits, RequirementList& list);

/// Creep factor of a static result: of the element for its own deflection, otherwise 1.
[[nodiscard]] double creep_in(const model::System& system, const std::string& name);

}  // namespace trivet::study
