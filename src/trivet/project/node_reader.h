// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/names_in_file.h"

namespace trivet::project {

/// Reads the table `nodes` into the description, after its bodies, and reports its problems.
void read_nodes(TableReader& root, model::Description& description, NamesInFile& in_file);

}  // namespace trivet::project
