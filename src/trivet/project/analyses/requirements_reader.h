// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/selection_reader.h"

namespace trivet::project {

/// Reads [requirements], if the file has them. Call it after [analyses], [limits] and [limit_lines].
void read_requirements(TableReader& root, const ResultNames& names, const NamesInFile& in_file, Analyses& result);

/// Reports requirements that a valid model cannot be judged by.
void check_requirements(const model::System& system, const Analyses& asked, foundation::Problems& problems);

}  // namespace trivet::project
