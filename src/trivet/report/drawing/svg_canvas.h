// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/in_documents.h"

namespace trivet::report {

struct PixelPoint {
  double x = 0;
  double y = 0;
};

/// As many letters of a text as fit a width [pixels] in letters of a size, the last one "…" if some do not.
[[nodiscard]] std::string fitting(const std::string& text, double width, double size);

/// Collects SVG elements; coordinates in pixels, y downwards.
class SvgCanvas {
 public:
  SvgCanvas(double width, double height) : width_(width), height_(height) {}

  void line(PixelPoint a, PixelPoint b, std::string_view style);
  void polyline(const std::vector<PixelPoint>& points, std::string_view style);
  /// Closed outlines, filled even–odd.
  void area(const std::vector<std::vector<PixelPoint>>& rings, std::string_view style);
  /// Clips everything drawn until `end_clip` to the inside of closed outlines (even–odd).
  /// @param name  distinguishes this outline from those of other pictures on one page
  void begin_clip(const std::vector<std::vector<PixelPoint>>& rings, std::string_view name);
  void end_clip();
  /// Gives everything drawn until `end_group` these attributes.
  void begin_group(std::string_view attributes);
  void end_group();
  void circle(PixelPoint centre, double radius, std::string_view style);
  void rectangle(PixelPoint corner, double width, double height, std::string_view style);
  /// `attributes` may contain anchor, size, weight, transform.
  void text(PixelPoint at, std::string_view content, std::string_view attributes);
  /// Permits a page break at a height: everything drawn before is above it, everything drawn later is below it.
  void permit_break(double y);
  /// Makes the picture at least this high.
  void reach(double height) { height_ = std::max(height_, height); }

  [[nodiscard]] std::string svg(std::string_view description) const;
  /// The same picture as several, one below the other, divided at the permitted page breaks.
  [[nodiscard]] std::vector<std::string> strips(std::string_view description) const;

 private:
  /// A permitted page break, and the length of the text of what is above it.
  struct Break {
    double y = 0;
    std::size_t length = 0;
  };
  double width_, height_;
  std::string body_;
  std::vector<Break> breaks_;
};

}  // namespace trivet::report
