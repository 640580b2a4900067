// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/names_in_file.h"

namespace trivet::project {

/// Reads [measurements] with their files, after the model and [analyses]. Each measured function becomes a curve of a
/// result: by `channels`, by `nodes`, by the name of a result in the file, or by the position of its node.
void read_measurements(TableReader& root, const model::Description& description, const NamesInFile& in_file,
                       Analyses& analyses);

}  // namespace trivet::project
