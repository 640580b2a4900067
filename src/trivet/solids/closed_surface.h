// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/solids/stl_file.h"
#include "trivet/solids/volume_integrals.h"

namespace trivet::solids {

/// What a closed surface of triangles encloses: exact integrals over the polyhedron, in the units of its file.
struct EnclosedVolume {
  VolumeIntegrals integrals;
  int shells = 0;                  ///< connected parts of the surface
  int cavities = 0;                ///< those of them that face inwards, inside another shell
  foundation::Problems remarks{};  ///< warnings: degenerate triangles, edges where shells touch
};

/// Volume enclosed by a surface that is closed (each edge used once in each direction) and faces outwards. Else every
/// problem with the place of it in the file's coordinates: each hole, triangles that are turned over, shells inside
/// out, no volume. Subject "file". Surfaces that cut through themselves are not found.
[[nodiscard]] foundation::Expected<EnclosedVolume> enclosed_volume(const TriangleSurface& surface);

}  // namespace trivet::solids
