// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/names_in_file.h"

namespace trivet::project {

/// Reads the table `foundations` and puts the elements of `in_file.foundation_references` on them: each element gets
/// its own impedance between its end N and the ground, or all of them share the modes of one structure.
void read_foundations(TableReader& root, model::Description& description, NamesInFile& in_file);

}  // namespace trivet::project
