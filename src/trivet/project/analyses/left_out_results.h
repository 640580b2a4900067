// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"

namespace trivet::project {

/// Reports requested results that do not exist because no element holds that direction of a node.
void refuse_left_out_results(const model::System& system, const Analyses& asked, foundation::Problems& problems);

}  // namespace trivet::project
