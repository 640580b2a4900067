// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/project/analyses/steady_question.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

/// The motions that a question asks for, with as many harmonics as it needs.
/// @throws foundation::InvalidInput for a linear machine, foundation::NotComputable if there is no motion to begin with
/// @param quantities  of points, one per result asked for; empty: the one of the question
[[nodiscard]] nonlinear::SteadyBranch steady_motions(const CaseContext& context, const project::SteadyQuestion& asked,
                                                     const std::vector<assembly::MotionQuantity>& quantities = {});

/// What may be wrong about such motions.
void warn_of_motions(const CaseContext& context, const project::SteadyQuestion& asked,
                     const nonlinear::SteadyBranch& motions, foundation::Problems& warnings);

}  // namespace trivet::study
