// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

/// What names the deflection of a mount along its axis after its own name.
inline constexpr const char* deflection_along_axis = ".deflection.z";

/// Adds what the makers of catalogue mounts allow: static loads and deflections, deflections under the harmonic
/// excitations and over the transient. A limit without an excitation that causes such a motion is noted.
void add_mount_requirements(const CaseContext& context, const project::Analyses& analyses,
                            foundation::Problems& warnings, RequirementList& list);

}  // namespace trivet::study
