// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/report/drawing/svg_canvas.h"

namespace trivet::report {

/// Rectangle on the canvas [pixels], y downwards.
struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  [[nodiscard]] bool contains(const Box& other) const {
    return left <= other.left && other.right <= right && top <= other.top && other.bottom <= bottom;
  }
};

/// Does the line between two points cross a rectangle?
[[nodiscard]] bool crosses(const Box& box, PixelPoint a, PixelPoint b);

/// Width of a text in the sans-serif font of the pictures, at least its true one [pixels].
[[nodiscard]] double text_width(std::string_view text, double font_size);

/// A name and the place that it names.
struct Label {
  std::string text;
  PixelPoint place;
};

/// Where a name is written, and its leader line from the place.
struct PlacedLabel {
  Box box;
  PixelPoint baseline;  ///< start of the text
  PixelPoint leader;    ///< end of the line from the place, at the box
};

/// Puts names beside their places, one after the other, each at the nearest spot where it covers no other name, no mark
/// and no leader line. Empty where there is none inside `area`.
/// @param marks  rectangles to keep free, the places themselves among them
[[nodiscard]] std::vector<std::optional<PlacedLabel>> placed_labels(const std::vector<Label>& labels, const Box& area,
                                                                    const std::vector<Box>& marks, double font_size);

}  // namespace trivet::report
