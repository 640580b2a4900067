// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/selection_reader.h"

namespace trivet::project {

/// Reads `optimize` of the analyses, if there is one. Call it after the parameters and the response.
void read_optimize(TableReader& root, TableReader& analyses, const ResultNames& names, const NamesInFile& in_file,
                   Analyses& result);

}  // namespace trivet::project
