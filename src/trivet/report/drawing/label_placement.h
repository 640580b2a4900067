// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

/// What labels keep off.
struct Obstacles {
  std::vector<Box> marks;                                     ///< to keep free, the places of the labels among them
  std::vector<std::pair<PixelPoint, PixelPoint>> lines = {};  ///< to keep off if there is room nearby
};

/// Puts names beside their places, one after the other, each at the nearest spot where it covers no other name, no mark
/// and no leader line, nor a line of the drawing if such a spot is near. Empty where there is none inside `area`.
[[nodiscard]] std::vector<std::optional<PlacedLabel>> placed_labels(const std::vector<Label>& labels, const Box& area,
                                                                    const Obstacles& obstacles, double font_size);

}  // namespace trivet::report
