// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/study/sample/sample.h"
#include "trivet/study/sample/sampled_case.h"

namespace trivet::study {

/// Shares of the variance of the values of all requirements that have one, by sets of drawn numbers that do not depend
/// on the others. The same for any number of threads.
[[nodiscard]] SampledShares variance_shares(const std::vector<SampledCase>& cases,
                                            const std::vector<project::Tolerance>& tolerances,
                                            const project::SampleRequest& request,
                                            const foundation::Progress& progress);

}  // namespace trivet::study
