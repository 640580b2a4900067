// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/selection_reader.h"

namespace trivet::project {

/// Reads `map` of the analyses, if there is one, with its own limits. Call it after all other analyses are read.
void read_map(TableReader& root, TableReader& analyses, const ResultNames& names, const NamesInFile& in_file,
              Analyses& result);

/// Gives a map without own limits those of the file, which are for the quantity of the response.
void use_limits_of_file(Analyses& analyses);

}  // namespace trivet::project
