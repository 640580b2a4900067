// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/names_in_file.h"

namespace trivet::project {

/// Reads the table `excitations` into the description and reports its problems.
void read_excitations(TableReader& root, model::Description& description, NamesInFile& in_file);

}  // namespace trivet::project
