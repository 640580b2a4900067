// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/mentioned.h"

namespace trivet::project {

/// `bodies` of the file; adds to the description and reports its problems.
/// @param known  read earlier; bodies that are the same there are taken from it
void read_bodies(TableReader& root, model::Description& description, Mentioned& mentioned,
                 const KnownModel* known = nullptr);

}  // namespace trivet::project
