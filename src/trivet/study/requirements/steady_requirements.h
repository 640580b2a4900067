// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

/// Adds what a nonlinear machine must not do in steady motion: jump, close a gap, or exceed an amplitude. Judged on the
/// branch of motions that is connected with the lower end of the band; and, for no_jump, of detached ones that a search
/// finds.
void add_steady_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list);

}  // namespace trivet::study
