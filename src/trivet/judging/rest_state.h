// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"

/// Nonlinear machines: the project file gives them undeformed, analyses are about rest.
namespace trivet::judging {

/// Puts a nonlinear machine into its position of rest; an error if there is none. A linear one stays as it is.
void settle(model::System& system, foundation::Problems& problems);

/// Warns of analyses of a nonlinear machine that depend on large motions, but are linear about rest.
void warn_of_small_motions(const model::System& system, const project::Analyses& request,
                           foundation::Problems& problems);

}  // namespace trivet::judging
