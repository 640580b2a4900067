// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/table.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/operation_types.h"

/// Root mean squares in frequency bands at the speeds of a machine.
namespace trivet::results {

/// All levels, for programs.
[[nodiscard]] Table operating_levels(const study::OperationResult& found);

/// Those of one speed, for people: velocities, and what a limit line bounds.
[[nodiscard]] Table shown_levels(const study::OperationResult& found, const assembly::Band& speed);

}  // namespace trivet::results
