// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"
#include "trivet/project/analysis_filter.h"
#include "trivet/project/read_case.h"

namespace trivet::judging {

/// Reports a number of the map or of [parameters.NAME] that no design can have (a second law of damping, a unit of
/// another quantity): the model cannot be read and settled with it anywhere in its range. Numbers of the map are tried
/// at the ends and the middle of their ranges, at 1, and together with the other number; parameters each alone.
/// @param read  with its system in the position of rest, if it has one
void check_corners(const project::ReadCase& read, bool of_map, bool of_parameters,
                   const project::AnalysisFilter& filter, foundation::Problems& problems);

}  // namespace trivet::judging
