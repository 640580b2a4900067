// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/table.h"
#include "trivet/project/text/display_units.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/operation_types.h"

/// Limits at the speeds of a machine, each at its level.
namespace trivet::results {

/// All limits, for programs.
[[nodiscard]] Table operating_limits(const study::OperationResult& found);

/// Those at one speed, for people.
[[nodiscard]] Table shown_limits(const study::OperatingSpeed& at, const project::DisplayUnits& display);

}  // namespace trivet::results
