// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/curve_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "trivet/report/drawing/label_placement.h"

namespace trivet::report {

namespace {

constexpr double air = 0.12;  // of an axis, for the text of a mark beyond the curves

/// Has the value a position on the axis or beyond its ends?
bool drawable(const Axis& axis, double value) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

/// The part of a segment inside the unit square, as shares of its length (Liang and Barsky).
bool clipped(PixelPoint a, PixelPoint b, double& from, double& to) {
  from = 0;
  to = 1;
  for (const auto& [start, step] : {std::pair{a.x, b.x - a.x}, std::pair{a.y, b.y - a.y}})
    for (const auto& [p, q] : {std::pair{-step, start}, std::pair{step, 1 - start}}) {
      if (p == 0) {
        if (q < 0) return false;
      } else if (p < 0) {
        from = std::max(from, q / p);
      } else {
        to = std::min(to, q / p);
      }
    }
  return from <= to;
}

/// First, lowest, highest and last point of every column of half a pixel.
std::vector<PixelPoint> thinned(const std::vector<PixelPoint>& points) {
  std::vector<PixelPoint> kept;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i, low = i, high = i;
    for (; end < points.size() && std::floor(2 * points[end].x) == std::floor(2 * points[i].x); ++end) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
    }
    std::size_t last = points.size();
    for (const std::size_t each : {i, std::min(low, high), std::max(low, high), end - 1})
      if (each != last) kept.push_back(points[last = each]);
    i = end;
  }
  return kept;
}

/// From the stretch between two points: a curve may go beyond its ends and come back.
double distance_to_stretch(PixelPoint point, PixelPoint a, PixelPoint b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double share = square > 0 ? std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(point.x - a.x - share * dx, point.y - a.y - share * dy);
}

/// Marks the points of a curve that a line within `tolerance` of it needs [pixels] (Douglas and Peucker).
void keep_corners(const std::vector<PixelPoint>& points, std::size_t from, std::size_t to, std::vector<bool>& kept) {
  constexpr double tolerance = 0.1;
  double farthest = tolerance;
  std::size_t corner = from;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double distance = distance_to_stretch(points[i], points[from], points[to]);
    if (distance > farthest) farthest = distance, corner = i;
  }
  if (corner == from) return;
  kept[corner] = true;
  keep_corners(points, from, corner, kept);
  keep_corners(points, corner, to, kept);
}

std::vector<PixelPoint> corners(const std::vector<PixelPoint>& points) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  keep_corners(points, 0, points.size() - 1, kept);
  std::vector<PixelPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

}  // namespace

std::vector<std::vector<PixelPoint>> visible_pieces(const PlotPanel& p, const std::vector<double>& x,
                                                    const std::vector<double>& y) {
  const auto share = [&](std::size_t i) { return PixelPoint{p.x.position(x[i]), p.y.position(y[i])}; };
  const auto pixel = [&](PixelPoint s) {
    return PixelPoint{p.corner.x + s.x * p.width, p.corner.y + (1 - s.y) * p.height};
  };
  std::vector<std::vector<PixelPoint>> pieces;
  bool open = false;
  for (std::size_t i = 1; i < std::min(x.size(), y.size()); ++i) {
    const auto known = [&](std::size_t k) { return drawable(p.x, x[k]) && drawable(p.y, y[k]); };
    double from = 0, to = 0;
    if (!known(i - 1) || !known(i) || !clipped(share(i - 1), share(i), from, to)) {
      open = false;
      continue;
    }
    const PixelPoint a = share(i - 1), b = share(i);
    const auto part = [&](double t) { return pixel({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}); };
    if (!open) pieces.push_back({part(from)});
    pieces.back().push_back(part(to));
    open = to == 1;
  }
  for (auto& piece : pieces) piece = corners(thinned(piece));
  return pieces;
}

std::vector<PanelCurve> turning_curve(const std::vector<double>& x, const std::vector<double>& y,
                                      const std::string& stroke, const std::string& key) {
  std::vector<PanelCurve> curves;
  for (std::size_t i = 0; i + 1 < x.size();) {
    const bool rises = x[i + 1] > x[i];
    PanelCurve piece{{}, {x[i]}, {y[i]}, stroke};
    for (++i; i < x.size(); ++i) {
      piece.x.push_back(x[i]);
      piece.y.push_back(y[i]);
      if (i + 1 == x.size() || (x[i + 1] > x[i]) != rises) break;
    }
    if (!rises) {
      std::ranges::reverse(piece.x);
      std::ranges::reverse(piece.y);
    }
    if (curves.empty()) piece.key = {key};
    curves.push_back(std::move(piece));
  }
  return curves;
}

namespace {

void draw_area(SvgCanvas& canvas, const PlotPanel& panel, const PanelArea& area) {
  const auto inside = [&](std::size_t i, double y) {
    return panel.at(area.x[i], std::isnan(y) ? panel.y.from : std::clamp(y, panel.y.from, panel.y.to));
  };
  std::vector<PixelPoint> ring;
  for (std::size_t i = 0; i < area.x.size(); ++i) ring.push_back(inside(i, area.low[i]));
  for (std::size_t i = area.x.size(); i-- > 0;) ring.push_back(inside(i, area.high[i]));
  canvas.area({ring}, fmt::format("fill=\"{}\"", area.colour));
}

}  // namespace

void draw_row(SvgCanvas& canvas, const PlotPanel& panel, const PanelRow& row) {
  for (const auto& [from, to] : row.shaded) {
    const double left = panel.at(from, panel.y.from).x, right = panel.at(to, panel.y.from).x;
    canvas.rectangle({left, panel.corner.y}, std::max(right - left, 1.0), panel.height, "fill=\"#f7d9d0\"");
  }
  for (const PanelArea& area : row.areas) draw_area(canvas, panel, area);
  draw_frame(canvas, panel);
  for (const double level : row.levels)
    canvas.line(panel.at(panel.x.from, level), panel.at(panel.x.to, level), "stroke=\"#333\" stroke-width=\"0.9\"");
  std::vector<std::vector<PixelPoint>> lines;
  for (const PanelCurve& curve : row.curves)
    for (auto& piece : visible_pieces(panel, curve.x, curve.y)) {
      canvas.polyline(piece, curve.stroke);
      lines.push_back(std::move(piece));
    }
  draw_panel_marks(canvas, panel, row.marks, lines);
}

Axis logarithmic_axis(const std::vector<PanelCurve>& curves, double depth, std::string label) {
  double largest = 0;
  for (const PanelCurve& curve : curves)
    for (const double y : curve.y)
      if (std::isfinite(y)) largest = std::max(largest, y);
  if (!(largest > 0)) return {0.1, 1, true, std::move(label)};
  double smallest = largest;
  for (const PanelCurve& curve : curves)
    for (const double y : curve.y)
      if (std::isfinite(y) && y >= depth * largest) smallest = std::min(smallest, y);
  smallest = 0.8 * std::min(smallest, 0.2 * largest);
  return {smallest, largest * std::pow(largest / smallest, air), true, std::move(label)};
}

Axis airy_axis(double from, double to, std::string label) {
  const double room = to > from ? air * (to - from) : 1;
  return {from == 0 && to > 0 ? 0 : from - room, to == 0 && from < 0 ? 0 : to + room, false, std::move(label)};
}

namespace {

constexpr double mark_radius = 3;

struct TextPlace {
  PixelPoint at;
  std::string_view anchor;
};

Box box_of(const PanelMark& mark, const TextPlace& place) {
  constexpr double font = 11, height = 11, descent = 3;  // a box of letters is higher than their ink
  const double width = text_width(mark.text, font);
  const double before = place.anchor == "end" ? width : place.anchor == "start" ? 0 : width / 2;
  return {place.at.x - before, place.at.y - height, place.at.x - before + width, place.at.y + descent};
}

Box box_of(const PixelPoint& at) {
  return {at.x - mark_radius, at.y - mark_radius, at.x + mark_radius, at.y + mark_radius};
}

bool is_crossed(const Box& box, const std::vector<std::vector<PixelPoint>>& lines) {
  for (const std::vector<PixelPoint>& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      if (crosses(box, line[i - 1], line[i])) return true;
  return false;
}

/// The first place that is free, inside the frame and off the lines, or else on them, or else beyond the frame, but not
/// below it, where ticks have their numbers.
std::optional<TextPlace> free_place(const PlotPanel& panel, const PanelMark& mark, const std::vector<Box>& taken,
                                    const std::vector<std::vector<PixelPoint>>& lines) {
  const PixelPoint at = panel.at(mark.x, mark.y);
  constexpr double above = -8, below = 17, line = 14, beside = 9, middle = 4, edge = 0.1;
  const double share = panel.x.share(mark.x);
  const char* anchor = share > 1 - edge ? "end" : share < edge ? "start" : "middle";
  const std::array<TextPlace, 13> places = {{{{at.x, at.y + above}, anchor},
                                             {{at.x, at.y + below}, anchor},
                                             {{at.x + beside, at.y + middle}, "start"},
                                             {{at.x - beside, at.y + middle}, "end"},
                                             {{at.x, at.y + above - line}, anchor},
                                             {{at.x, at.y + below + line}, anchor},
                                             {{at.x, at.y + above - 2 * line}, anchor},
                                             {{at.x, at.y + below + 2 * line}, anchor},
                                             {{at.x, at.y + above - 3 * line}, anchor},
                                             {{at.x + beside, at.y + above}, "start"},
                                             {{at.x - beside, at.y + above}, "end"},
                                             {{at.x + beside, at.y + below}, "start"},
                                             {{at.x - beside, at.y + below}, "end"}}};
  const Box frame = {panel.corner.x, panel.corner.y, panel.corner.x + panel.width, panel.corner.y + panel.height};
  std::optional<TextPlace> on_a_line, outside;
  for (const TextPlace& place : places) {
    const Box here = box_of(mark, place);
    if (here.bottom > frame.bottom ||
        std::ranges::any_of(taken, [&](const Box& other) { return here.overlaps(other); }))
      continue;
    if (!frame.contains(here)) outside = outside.value_or(place);
    else if (is_crossed(here, lines)) on_a_line = on_a_line.value_or(place);
    else return place;
  }
  return on_a_line ? on_a_line : outside;
}

}  // namespace

void draw_panel_marks(SvgCanvas& canvas, const PlotPanel& panel, const std::vector<PanelMark>& marks,
                      const std::vector<std::vector<PixelPoint>>& lines) {
  std::vector<Box> taken;
  for (const PanelMark& mark : marks) {
    const PixelPoint at = panel.at(mark.x, mark.y);
    taken.push_back(box_of(at));
    canvas.circle(at, mark_radius, fmt::format("fill=\"white\" stroke=\"{}\" stroke-width=\"1.4\"", mark.colour));
  }
  for (const PanelMark& mark : marks) {
    if (mark.text.empty()) continue;
    const std::optional<TextPlace> place = free_place(panel, mark, taken, lines);
    if (!place) continue;
    taken.push_back(box_of(mark, *place));
    canvas.text(place->at, mark.text,
                fmt::format("text-anchor=\"{}\" fill=\"{}\" paint-order=\"stroke\" stroke=\"white\" "
                            "stroke-width=\"3\" stroke-linejoin=\"round\"",
                            place->anchor, mark.colour));
  }
}

}  // namespace trivet::report
