// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/mentioned.h"

namespace trivet::project {

/// The table `foundations`, and the elements that name one of them (`mentioned.stands_on`): each gets its ground
/// point's own impedance between its end N and the ground, or all of them share the modes of one structure.
void read_foundations(TableReader& root, model::Description& description, Mentioned& mentioned);

}  // namespace trivet::project
