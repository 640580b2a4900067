// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/identification/hysteresis_loop.h"
#include "trivet/project/text/table_reader.h"

/// Hysteresis loops of a test rig in a CSV file: columns loop, displacement, force, and time, frequency_hz if known.
namespace trivet::project {

/// Reads `loops`, `length_unit` and `force_unit`, and fits each loop; none after reporting errors.
[[nodiscard]] std::optional<std::vector<identification::LoopFit>> read_loop_file(TableReader& reader);

/// Adds problems of the loops, at the key `loops`.
void add_loop_problems(TableReader& reader, const foundation::Problems& problems);

}  // namespace trivet::project
