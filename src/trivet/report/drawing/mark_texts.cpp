// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/mark_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace trivet::report {
namespace {

constexpr double mark_radius = 3;

struct TextBox {
  double left, top, right, bottom;
};

bool overlap(const TextBox& a, const TextBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

struct TextPlace {
  PixelPoint at;
  std::string_view anchor;
};

TextBox box_of(const PanelMark& mark, const TextPlace& place) {
  constexpr double per_letter = 6, height = 10, descent = 2;
  const double width = per_letter * static_cast<double>(mark.text.size());
  const double before = place.anchor == "end" ? width : place.anchor == "start" ? 0 : width / 2;
  return {place.at.x - before, place.at.y - height, place.at.x - before + width, place.at.y + descent};
}

TextBox box_of(const PixelPoint& at) {
  return {at.x - mark_radius, at.y - mark_radius, at.x + mark_radius, at.y + mark_radius};
}

/// The first place that is free, inside the frame or else beyond it, but not below it, where ticks have their numbers.
std::optional<TextPlace> free_place(const PlotPanel& panel, const PanelMark& mark, const std::vector<TextBox>& taken) {
  const PixelPoint at = panel.at(mark.x, mark.y);
  constexpr double above = -8, below = 17, line = 14, beside = 9, middle = 4, edge = 0.1;
  const double share = panel.x.share(mark.x);
  const char* anchor = share > 1 - edge ? "end" : share < edge ? "start" : "middle";
  const std::array<TextPlace, 9> places = {{{{at.x, at.y + above}, anchor},
                                            {{at.x, at.y + below}, anchor},
                                            {{at.x + beside, at.y + middle}, "start"},
                                            {{at.x - beside, at.y + middle}, "end"},
                                            {{at.x, at.y + above - line}, anchor},
                                            {{at.x, at.y + below + line}, anchor},
                                            {{at.x, at.y + above - 2 * line}, anchor},
                                            {{at.x, at.y + below + 2 * line}, anchor},
                                            {{at.x, at.y + above - 3 * line}, anchor}}};
  const TextBox frame = {panel.corner.x, panel.corner.y, panel.corner.x + panel.width, panel.corner.y + panel.height};
  for (const bool inside : {true, false})
    for (const TextPlace& place : places) {
      const TextBox here = box_of(mark, place);
      if (here.bottom > frame.bottom) continue;
      if (inside && (here.left < frame.left || here.right > frame.right || here.top < frame.top)) continue;
      if (std::ranges::none_of(taken, [&](const TextBox& other) { return overlap(here, other); })) return place;
    }
  return std::nullopt;
}

}  // namespace

void draw_panel_marks(SvgCanvas& canvas, const PlotPanel& panel, const std::vector<PanelMark>& marks) {
  std::vector<TextBox> taken;
  for (const PanelMark& mark : marks) {
    const PixelPoint at = panel.at(mark.x, mark.y);
    taken.push_back(box_of(at));
    canvas.circle(at, mark_radius, fmt::format("fill=\"white\" stroke=\"{}\" stroke-width=\"1.4\"", mark.colour));
  }
  for (const PanelMark& mark : marks) {
    if (mark.text.empty()) continue;
    const std::optional<TextPlace> place = free_place(panel, mark, taken);
    if (!place) continue;
    taken.push_back(box_of(mark, *place));
    canvas.text(place->at, mark.text,
                fmt::format("text-anchor=\"{}\" fill=\"{}\" paint-order=\"stroke\" stroke=\"white\" "
                            "stroke-width=\"3\" stroke-linejoin=\"round\"",
                            place->anchor, mark.colour));
  }
}

}  // namespace trivet::report
