// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Reads `x` and `y` of a map. @param parameters  [parameters.NAME], which an axis may name
void read_axes(TableReader& root, TableReader& map, const std::vector<DesignAxis>& parameters, MapRequest& request);

/// Reads `pairs` of a map, and `points` for all of their axes; the first pair is x and y too.
void read_pairs(TableReader& root, TableReader& map, const std::vector<DesignAxis>& parameters, MapRequest& request);

}  // namespace trivet::project
