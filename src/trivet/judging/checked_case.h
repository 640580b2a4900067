// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/foundation/problems.h"
#include "trivet/project/analysis_filter.h"
#include "trivet/project/project.h"
#include "trivet/project/read_case.h"

namespace trivet::judging {

/// A case that was read, its nonlinear machine in the position of rest, its analyses checked against it. None if there
/// are errors; adds all problems. A map that equals that of `base` is not checked again, nor are parameters of a case.
[[nodiscard]] std::optional<project::Case> checked_case(project::ReadCase read, const project::AnalysisFilter& filter,
                                                        const project::Case* base, foundation::Problems& problems);

}  // namespace trivet::judging
