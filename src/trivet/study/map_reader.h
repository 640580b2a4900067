// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/wanted_reader.h"

namespace trivet::study {

/// `map` of the analyses, if there is one, with the limits of the file where it has none of its own. Reads after all other analyses.
void read_map(TableReader& root, TableReader& analyses, const ResultNames& names, const Mentioned& mentioned, Analyses& result);

/// Without a map of its own nothing but the file's limits hold: adds them with the quantity and excitations of the response.
void take_limits_of_file(Analyses& analyses);

}  // namespace trivet::study
