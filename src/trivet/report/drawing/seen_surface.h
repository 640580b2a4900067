// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "trivet/report/drawing/view_projection.h"

namespace trivet::report {

/// What is seen of a surface: the area that it covers, and its outline and sharp edges.
struct SeenSurface {
  std::vector<std::vector<PixelPoint>> faces;  ///< those towards the viewer
  std::vector<std::pair<PixelPoint, PixelPoint>> lines;
};
/// @param surface  in the ground frame
[[nodiscard]] SeenSurface seen(const SolidSurface& surface, const Projection& projection);

}  // namespace trivet::report
