// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::report {

void draw_case_mark(SvgCanvas& canvas, PixelPoint p, bool feasible) {
  canvas.circle(p, 4.5,
                feasible ? "fill=\"black\" stroke=\"white\" stroke-width=\"1.5\""
                         : "fill=\"white\" stroke=\"black\" stroke-width=\"1.6\"");
  if (feasible) return;
  canvas.line({p.x - 2, p.y - 2}, {p.x + 2, p.y + 2}, "stroke=\"black\" stroke-width=\"1.3\"");
  canvas.line({p.x - 2, p.y + 2}, {p.x + 2, p.y - 2}, "stroke=\"black\" stroke-width=\"1.3\"");
}

void draw_best(SvgCanvas& canvas, PixelPoint p, bool feasible) {
  canvas.area({{{p.x, p.y - 7}, {p.x + 6, p.y}, {p.x, p.y + 7}, {p.x - 6, p.y}}},
              feasible ? "fill=\"#0072B2\" stroke=\"white\" stroke-width=\"1.2\""
                       : "fill=\"white\" stroke=\"#0072B2\" stroke-width=\"2\"");
}

namespace {

/// Does a line of margin 1 run through a box?
bool meets_boundary(const MapPicture& picture, const Box& box) {
  constexpr double step = 3;  // pixels, less than the height of a letter
  for (const design::MapLine& line : picture.map.feasible.lines)
    for (std::size_t k = 1; k < line.size(); ++k) {
      const PixelPoint a = picture.at(line[k - 1]), b = picture.at(line[k]);
      const int pieces = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / step);
      for (int i = 0; i <= pieces; ++i) {
        const double x = a.x + (b.x - a.x) * i / pieces, y = a.y + (b.y - a.y) * i / pieces;
        if (x > box.left && x < box.right && y > box.top && y < box.bottom) return true;
      }
    }
  return false;
}

/// Places a label next to the point where it covers nothing, otherwise farther away with a leader. Returns whether
/// there was room.
bool is_placed(MapPicture& picture, PixelPoint p, const std::string& text, bool on_boundary) {
  const double width = width_of(text);
  for (const double distance : {9.0, 20.0, 34.0, 50.0, 70.0})
    for (const auto& [dx, dy] : {std::pair{1.0, 0.0},
                                 {0.0, -1.0},
                                 {0.0, 1.0},
                                 {-1.0, 0.0},
                                 {0.8, -0.8},
                                 {0.8, 0.8},
                                 {-0.8, -0.8},
                                 {-0.8, 0.8}}) {
      const double left = p.x + dx * distance -
          (dx < 0        ? width
               : dx == 0 ? width / 2
                         : 0),
                   base = p.y + 4 + dy * (distance + 4);
      const Box box{left - 2, base - 11, left + width + 2, base + 3};
      if (!picture.is_free(box) || (!on_boundary && meets_boundary(picture, box))) continue;
      picture.taken.push_back(box);
      if (distance > 9)
        picture.canvas.line({p.x + 5 * dx, p.y + 5 * dy},
                            {std::clamp(p.x + dx * distance, left, left + width),
                             base - 4 +
                                 (dy < 0       ? 5
                                      : dy > 0 ? -5
                                               : 0)},
                            "stroke=\"#333\" stroke-width=\"0.8\"");
      picture.canvas.text({left, base}, text, halo);
      return true;
    }
  return false;
}

/// Places a label, on a line of margin 1 only if there is no other room.
void place_label(MapPicture& picture, PixelPoint p, const std::string& text) {
  if (!is_placed(picture, p, text, false)) static_cast<void>(is_placed(picture, p, text, true));
}

/// Sample and text of the best design, or of the nearest to feasible if none is feasible.
void explain_best(const MapPicture& picture, SvgCanvas& canvas, Key& key) {
  const study::DesignMap& map = picture.map;
  const design::DesignOutcome& best = map.outcomes[*map.best];
  const design::DesignPoint p = map.point(*map.best);
  draw_best(canvas, key.sample(), best.feasible());
  const std::size_t ends = results::best_ends(map).size();
  const std::string where =
      fmt::format("{}, {}{}", results::axis_value(p.x, map.request.x), results::axis_value(p.y, map.request.y),
                  ends == 0       ? ""
                      : ends == 1 ? ": an axis ends there"
                                  : ": both axes end there");
  if (std::isinf(best.margin)) key.add_text("middle of the designs that no rule limits", where);
  else if (best.margin == 0) key.add_text("middle design: every margin is 0", where);
  else
    key.add_text(fmt::format("{} {:.3g}", best.feasible() ? "largest margin:" : "nearest design: margin", best.margin),
                 where);
}

PixelPoint best_point(const MapPicture& picture) {
  const auto nx = to_size(picture.map.grid.nx);
  return picture.at(
      picture.map.grid.place(static_cast<int>(*picture.map.best % nx), static_cast<int>(*picture.map.best / nx)));
}

}  // namespace

std::vector<PlacedMark> placed_marks(const MapPicture& picture) {
  std::vector<PlacedMark> placed;
  for (const study::MapMark& mark : picture.map.marks) {
    if (!is_drawn(picture.map, mark)) continue;
    const PixelPoint p = picture.at({picture.map.request.x.share(*mark.x), picture.map.request.y.share(*mark.y)});
    const std::string name = mark.name.empty() ? "base" : mark.name;
    const auto same = std::ranges::find_if(
        placed, [&](const PlacedMark& m) { return std::hypot(m.point.x - p.x, m.point.y - p.y) < 1; });
    if (same == placed.end()) placed.push_back({p, name, mark.judged->governing.feasible()});
    else same->names += ", " + name;
  }
  return placed;
}

void keep_free(MapPicture& picture, const std::vector<PlacedMark>& placed) {
  const auto occupy = [&](PixelPoint p, double room) {
    picture.taken.push_back({p.x - room, p.y - room, p.x + room, p.y + room});
  };
  for (const PlacedMark& mark : placed) occupy(mark.point, 6);
  if (picture.map.best) occupy(best_point(picture), 8);
}

void draw_best_design(MapPicture& picture) {
  if (picture.map.best)
    draw_best(picture.canvas, best_point(picture), picture.map.outcomes[*picture.map.best].feasible());
}

void draw_marks(MapPicture& picture, const std::vector<PlacedMark>& placed, Key& key) {
  draw_best_design(picture);
  for (const PlacedMark& mark : placed) {
    draw_case_mark(picture.canvas, mark.point, mark.feasible);
    place_label(picture, mark.point, mark.names);
  }
  if (placed.empty() && !picture.map.best) return;
  key.heading("Points");
  for (const bool feasible : {true, false}) {
    if (std::ranges::none_of(placed, [&](const PlacedMark& m) { return m.feasible == feasible; })) continue;
    draw_case_mark(picture.canvas, key.sample(), feasible);
    key.add_text(feasible ? "case that meets every rule" : "case that violates a rule", "");
  }
  if (picture.map.best) explain_best(picture, picture.canvas, key);
}

}  // namespace trivet::report
