// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/mentioned.h"

namespace trivet::project {

/// `analyses`, `limits` and `limit_lines` of the file.
[[nodiscard]] Analyses read_analyses(TableReader& root, const Mentioned& mentioned);

}  // namespace trivet::project
