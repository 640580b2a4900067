// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/sample/kept_designs.h"
#include "trivet/study/sample/sample.h"
#include "trivet/study/sample/sample_run.h"
#include "trivet/study/sample/sample_tally.h"

namespace trivet::study {

/// What a tally says of all designs, without shares of the variance.
[[nodiscard]] Sample sample_result(const SampleRun& run, const SampleTally& all);

/// The designs that a tally keeps, and those with the least and the largest least margin.
[[nodiscard]] KeptDesigns kept_designs(const SampleRun& run, const SampleTally& all);

/// Searches the worst design of each requirement in each case.
/// @param found  of the same run
void add_worst_designs(const SampleRun& run, Sample& found, const foundation::Progress& progress);

}  // namespace trivet::study
