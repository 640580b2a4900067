// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/names_in_file.h"

namespace trivet::project {

/// `analyses`, `limits` and `limit_lines` of the file.
[[nodiscard]] Analyses read_analyses(TableReader& root, const NamesInFile& in_file);

}  // namespace trivet::project
