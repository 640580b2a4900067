// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/mentioned.h"

namespace trivet::project {

/// `elements` of the file; adds to the description and reports its problems.
void read_elements(TableReader& root, model::Description& description, Mentioned& mentioned);

/// `damping` of the whole system.
void read_system_damping(TableReader& root, model::Description& description);

}  // namespace trivet::project
