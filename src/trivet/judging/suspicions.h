// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "trivet/assembly/assembled_once.h"
#include "trivet/plausibility/suspicion.h"
#include "trivet/project/project.h"

namespace trivet::judging {

/// Suspicions about the machine and the analyses of a case, accepted or not.
/// @param assembled  its system
/// @param accepted  (table, kind); accepted values raise no suspicion about other values
[[nodiscard]] std::vector<plausibility::Suspicion> suspicions(
    const project::Case& variant, const assembly::AssembledOnce& assembled,
    const std::vector<std::pair<std::string, std::string>>& accepted = {});

/// Warnings about a band of the command line, as about that of [analyses.response], unless the file accepts them.
[[nodiscard]] foundation::Problems doubts_about_band(const project::Case& variant, const assembly::Band& band);

/// Adds the slip behind impossible bodies to their errors, if a single slip explains them.
void name_slips(const std::vector<model::Body>& bodies, const project::Node& document, foundation::Problems& problems);

}  // namespace trivet::judging
