// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/mentioned.h"

namespace trivet::project {

/// Reads the table `foundations` and puts the elements of `mentioned.stands_on` on them: each element gets its own
/// impedance between its end N and the ground, or all of them share the modes of one structure.
void read_foundations(TableReader& root, model::Description& description, Mentioned& mentioned);

}  // namespace trivet::project
