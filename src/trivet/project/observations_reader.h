// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/names_in_file.h"

namespace trivet::project {

/// Reads [relative], [sections] and [clearances], after all bodies, nodes and elements.
void read_observations(TableReader& root, model::Description& description, NamesInFile& in_file);

}  // namespace trivet::project
