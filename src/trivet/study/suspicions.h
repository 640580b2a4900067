// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/plausibility/suspicion.h"
#include "trivet/study/project.h"

namespace trivet::study {

/// What is doubtful in a case that was read: of its machine and of what is asked of it.
[[nodiscard]] std::vector<plausibility::Suspicion> suspicions(const Case& variant);

/// Names the slip behind bodies that are impossible, where a single one explains it.
void name_slips(const std::vector<model::Body>& bodies, const Node& document, foundation::Problems& problems);

}  // namespace trivet::study
