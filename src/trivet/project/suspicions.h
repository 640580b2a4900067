// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "trivet/plausibility/suspicion.h"
#include "trivet/project/project.h"

namespace trivet::project {

/// What is doubtful in a case that was read: of its machine and of what is asked of it, accepted or not.
/// @param accepted  tables and kinds: they cast no doubt on the rest
[[nodiscard]] std::vector<plausibility::Suspicion> suspicions(
    const Case& variant, const std::vector<std::pair<std::string, std::string>>& accepted = {});

/// Names the slip behind bodies that are impossible, where a single one explains it.
void name_slips(const std::vector<model::Body>& bodies, const Node& document, foundation::Problems& problems);

}  // namespace trivet::project
