// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/solids/stl_file.h"
#include "trivet/solids/volume_integrals.h"

namespace trivet::solids {

/// Volume inside a closed surface of triangles: exact integrals over the polyhedron, in the units of its file.
struct EnclosedVolume {
  VolumeIntegrals integrals;
  int shells = 0;                  ///< connected parts of the surface
  int cavities = 0;                ///< shells that face inwards, inside another shell
  foundation::Problems remarks{};  ///< warnings: rounding, repeated or degenerate triangles, edges where shells touch
};

/// Volume enclosed by a surface that is closed (each edge used once in each direction, after rounding and repeated
/// triangles are removed: welded_surface.h) and faces outwards. Otherwise all problems with their place in the file's
/// coordinates: holes, reversed triangles, shells inside out, no volume. Subject "file". Self-intersecting surfaces are
/// not detected.
[[nodiscard]] foundation::Expected<EnclosedVolume> enclosed_volume(const TriangleSurface& given);

}  // namespace trivet::solids
