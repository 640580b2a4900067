// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/wanted_reader.h"

namespace trivet::project {

/// `map` of the analyses, if there is one, with its own limits. Reads after all other analyses.
void read_map(TableReader& root, TableReader& analyses, const ResultNames& names, const Mentioned& mentioned,
              Analyses& result);

/// A map without limits of its own takes those of the file, which hold for the quantity of the response.
void take_limits_of_file(Analyses& analyses);

}  // namespace trivet::project
