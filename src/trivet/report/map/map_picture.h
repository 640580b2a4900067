// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/label_placement.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/study/map/design_map.h"

namespace trivet::report {

/// Style of a white outline around letters.
inline constexpr const char* halo =
    "paint-order=\"stroke\" stroke=\"white\" stroke-width=\"3.5\" stroke-linejoin=\"round\"";

/// Style of the layer over the colours of feasible designs.
inline constexpr const char* lighter = "fill=\"white\" fill-opacity=\"0.72\" stroke=\"none\"";

/// Approximate width of a line of 11 pixels height.
[[nodiscard]] double width_of(const std::string& text);

/// The frame of the panel of a single map [pixels of its picture].
struct MapFrame {
  PixelPoint corner;
  double width = 0, height = 0;
};
inline constexpr MapFrame map_frame{{96, 44}, 590, 520};

/// The panel of a map, and the areas that are occupied by text.
struct MapPicture {
  const study::DesignMap& map;
  SvgCanvas canvas;
  PlotPanel panel;
  std::vector<Box> taken = {};

  [[nodiscard]] PixelPoint at(const design::MapPlace& p) const {
    return {panel.corner.x + p.x * panel.width, panel.corner.y + (1 - p.y) * panel.height};
  }
  [[nodiscard]] std::vector<PixelPoint> line(const design::MapLine& places) const;
  [[nodiscard]] std::vector<std::vector<PixelPoint>> rings(const std::vector<design::MapLine>& lines) const;
  /// Is a box inside the frame and free of text?
  [[nodiscard]] bool is_free(const Box& box) const;
};

/// The key right of the panel: samples with their texts.
class Key {
 public:
  Key(SvgCanvas& canvas, PixelPoint at) : canvas_(canvas), at_(at) {}
  void heading(const std::string& text);
  void patch(const std::string& style, const std::string& text, const std::string& second = "");
  /// A sample of a colour as in the picture: full, lighter, or half and half.
  void region(const std::string& colour, bool infeasible, bool feasible, const std::string& text,
              const std::string& second);
  void stroke(const std::string& style, const std::string& text);
  /// Position of a sample of another kind.
  [[nodiscard]] PixelPoint sample() const { return {at_.x + 11, at_.y - 3}; }
  void add_text(const std::string& text, const std::string& second);

 private:
  SvgCanvas& canvas_;
  PixelPoint at_;
};

/// Name of an axis, with its unit in brackets.
[[nodiscard]] std::string axis_label(const project::DesignAxis& axis);

/// The axis as drawn in pictures: one that is short compared with its numbers starts at 0, and its label shows the
/// offset.
[[nodiscard]] Axis drawn_axis(const project::DesignAxis& axis);

/// Cases that are not in the picture, with their verdicts, one sentence for each reason; empty if all are drawn.
[[nodiscard]] std::vector<std::string> undrawn_cases(const study::DesignMap& map);

/// Is a mark drawn, as a design of this map inside its frame?
[[nodiscard]] bool is_drawn(const study::DesignMap& map, const study::MapMark& mark);

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
