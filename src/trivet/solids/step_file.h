// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"
#include "trivet/solids/volume_integrals.h"

namespace trivet::solids {

/// Volume, centre and second moment [m] of every solid in a STEP file, in the order and the frame of the file,
/// integrated over its exact surfaces (not over triangles) by the OpenCASCADE kernel of gmsh. The length unit of
/// the file is applied. Problems have the subject "file": no gmsh, not a STEP file, no solid in it, a solid without
/// volume.
[[nodiscard]] foundation::Expected<std::vector<VolumeIntegrals>> step_volumes(
    const std::filesystem::path& file, const foundation::Progress& progress = {});

}  // namespace trivet::solids
