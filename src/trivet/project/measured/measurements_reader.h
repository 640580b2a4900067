// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {

/// Reads [measurements] with their files, after the model and [analyses]. Each measured function becomes a curve of a
/// result: by `channels`, by `nodes`, by the name of a result in the file, or by the position of its node.
void read_measurements(TableReader& root, const model::Description& description, const SymbolTable& symbols,
                       Analyses& analyses);

}  // namespace trivet::project
