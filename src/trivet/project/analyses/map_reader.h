// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Reads `map` of the analyses, if there is one, with its own limits. Call it after all other analyses are read.
void read_map(TableReader& root, TableReader& analyses, const ResultNames& names, const SymbolTable& symbols,
              Analyses& result);

/// Gives a map without own limits those of the file, which are for the quantity of the response.
void use_limits_of_file(Analyses& analyses);

/// Reads `x` and `y` of a map. @param parameters  [parameters.NAME], which an axis may name
void read_axes(TableReader& root, TableReader& map, const std::vector<DesignAxis>& parameters, MapRequest& request);

/// Reads `pairs` of a map, and `points` for all of their axes; the first pair is x and y too.
void read_pairs(TableReader& root, TableReader& map, const std::vector<DesignAxis>& parameters, MapRequest& request);

}  // namespace trivet::project
