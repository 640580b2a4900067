// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/level.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Level of a limit line, rms or zero-to-peak: that of the key `level`, else the one that its numbers or their unit
/// have ("4.5 mm/s 0-p", unit = "mm/s p-p"), else rms. Contradictions are errors.
/// @param over_bands  the numbers are root mean squares; other levels are reported where the numbers are read
[[nodiscard]] Level read_level_of_line(TableReader& reader, bool over_bands);

}  // namespace trivet::project
