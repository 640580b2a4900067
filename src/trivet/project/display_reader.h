// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/shown_units.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Reads [display].
[[nodiscard]] ShownUnits read_display(TableReader& root);

}  // namespace trivet::project
