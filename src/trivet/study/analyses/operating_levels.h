// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/analyses/operation_types.h"

namespace trivet::study {

/// Levels in the bands of the request at its speeds, with the lines over these bands: of the given results and of those
/// that a line bounds. Every band that an order reaches has one; under a line it has the random vibration besides.
/// @param loads  the excitations that run, at least one  @param channels  velocities, and forces
[[nodiscard]] std::vector<OperatingLevel> operating_levels(const CaseContext& context,
                                                           const project::OperationAnalysis& request,
                                                           const std::vector<response::OrderLoading>& loads,
                                                           std::vector<assembly::Channel> channels);

/// The lines of the request over its bands at each of its speeds. @param levels  those of the same request
[[nodiscard]] std::vector<OperatingLine> operating_lines(const project::OperationAnalysis& request,
                                                         const std::vector<OperatingLevel>& levels);

}  // namespace trivet::study
