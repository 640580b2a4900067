// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/analyses/operation_types.h"

namespace trivet::study {

/// The limits of [operation] with all orders together: for each speed, in the order of the file. A limit in rms bounds
/// the root mean square, one zero-to-peak the largest |y(t)|, one peak-to-peak the difference of the largest and the
/// least y(t).
/// @param loads  the excitations that run, at least one
[[nodiscard]] std::vector<std::vector<OperatingLimit>> operating_limits(
    const CaseContext& context, const project::OperationAnalysis& request,
    const std::vector<response::OrderLoading>& loads);

/// The request at one of its speeds, or over one of its ranges.
[[nodiscard]] project::OperationAnalysis at_speed(project::OperationAnalysis request, const assembly::Band& speed);

/// The upper end of the fastest range of speeds [rad/s]; 0 of single speeds.
[[nodiscard]] double fastest_range(const std::vector<assembly::Band>& speeds);

}  // namespace trivet::study
