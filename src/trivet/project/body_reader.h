// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/known_model.h"
#include "trivet/project/text/names_in_file.h"

namespace trivet::project {

/// Reads the table `bodies` into the description and reports its problems.
/// @param known  a model read earlier; unchanged bodies are copied from it
void read_bodies(TableReader& root, model::Description& description, NamesInFile& in_file,
                 const KnownModel* known = nullptr);

/// Reads `free` of a body or node, and lists its constrained coordinates.
void read_free(TableReader& reader, model::Body& body, NamesInFile& in_file);

}  // namespace trivet::project
