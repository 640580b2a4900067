// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "trivet/solids/stl_file.h"

namespace trivet::solids {

/// Triangles on the surface of every solid of a STEP file, in the order and the frame of the file [m], for drawings: 36
/// along a full turn, vertices on the exact surface. gmsh runs once for each state of a file (its size and time of
/// change) as long as the program runs; others who ask for the same file meanwhile wait. Null: gmsh cannot mesh it, or
/// did not in 60 s or TRIVET_GMSH_SECONDS; it is tried again when ten times as long has passed as that took.
/// Mass properties do not need it: step_volumes.
/// @throws foundation::Interrupted from the thread_progress()
[[nodiscard]] std::shared_ptr<const std::vector<TriangleSurface>> step_surfaces(const std::filesystem::path& file);

}  // namespace trivet::solids
