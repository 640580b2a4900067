// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/map/map_picture.h"

namespace trivet::report {

struct PlacedMark {
  PixelPoint point;
  std::string names;
  bool feasible = false;
};

/// Cases of this model inside the frame; cases at one place share a label.
[[nodiscard]] std::vector<PlacedMark> placed_marks(const MapPicture& picture);

/// Reserves the area of the points, so that no text covers them.
void keep_free(MapPicture& picture, const std::vector<PlacedMark>& placed);

/// Draws the best design, if there is one.
void draw_best_design(MapPicture& picture);

/// Draws the sign of a case: a black point, or a cross in a circle if it violates a rule.
void draw_case_mark(SvgCanvas& canvas, PixelPoint at, bool feasible);

/// Draws the sign of the best design, filled if it is feasible.
void draw_best(SvgCanvas& canvas, PixelPoint at, bool feasible);

/// Draws the best design and the cases with their names.
void draw_marks(MapPicture& picture, const std::vector<PlacedMark>& placed, Key& key);

}  // namespace trivet::report
