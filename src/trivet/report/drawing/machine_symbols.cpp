// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/machine_symbols.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "trivet/foundation/constants.h"

namespace trivet::report {
namespace {

std::string line_style(const std::string& colour, double width) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{:.1f}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"", colour,
                     width);
}

/// Unit vector from a to b, and its length.
struct Course {
  PixelPoint along;
  double length;
};
Course course(PixelPoint a, PixelPoint b) {
  const double x = b.x - a.x, y = b.y - a.y, length = std::hypot(x, y);
  return {length > 0 ? PixelPoint{x / length, y / length} : PixelPoint{0, 1}, length};
}

constexpr double seen_as_point = 5;

void draw_head(SvgCanvas& canvas, PixelPoint tip, PixelPoint along, const std::string& colour) {
  constexpr double length = 8, half = 3;
  const PixelPoint base{tip.x - length * along.x, tip.y - length * along.y};
  canvas.area(
      {{tip, {base.x - half * along.y, base.y + half * along.x}, {base.x + half * along.y, base.y - half * along.x}}},
      fmt::format("fill=\"{}\"", colour));
}

}  // namespace

void draw_spring(SvgCanvas& canvas, PixelPoint a, PixelPoint b, const std::string& colour, double width) {
  const auto [along, length] = course(a, b);
  if (length < seen_as_point) {
    canvas.circle(b, 5.5, "fill=\"white\" " + line_style(colour, width));
    canvas.circle(b, 2.2, "fill=\"none\" " + line_style(colour, width));
    return;
  }
  constexpr int turns = 4;
  const double straight = 0.14 * length, half = std::min(5.0, 0.25 * length);
  std::vector<PixelPoint> points = {a};
  const auto add = [&](double way, double across) {
    points.push_back({a.x + way * along.x - across * along.y, a.y + way * along.y + across * along.x});
  };
  const double pitch = (length - 2 * straight) / turns;
  add(straight, 0);
  for (int i = 0; i < turns; ++i) {
    add(straight + (i + 0.25) * pitch, half);
    add(straight + (i + 0.75) * pitch, -half);
  }
  add(length - straight, 0);
  points.push_back(b);
  canvas.polyline(points, line_style(colour, width));
}

void draw_beam(SvgCanvas& canvas, PixelPoint a, PixelPoint b, const std::string& colour) {
  canvas.line(a, b, line_style(colour, 4.6));
  canvas.line(a, b, line_style("white", 2.6));
}

void draw_support(SvgCanvas& canvas, PixelPoint at, PixelPoint from, DrawnMachine::Support support,
                  const std::string& colour) {
  if (support == DrawnMachine::Support::body) return;
  const auto [along, length] = course(from, at);
  if (length < seen_as_point) return;
  constexpr double half = 9, hatch = 5;
  const PixelPoint across{-along.y, along.x};
  const auto place = [&](double sideways, double deep) {
    return PixelPoint{at.x + sideways * across.x + deep * along.x, at.y + sideways * across.y + deep * along.y};
  };
  canvas.line(place(-half, 0), place(half, 0), line_style(colour, 1.4));
  if (support == DrawnMachine::Support::foundation) {
    canvas.line(place(-half, 3), place(half, 3), line_style(colour, 1.4));
    return;
  }
  for (double sideways = -half + 3; sideways <= half; sideways += 5)
    canvas.line(place(sideways, 0), place(sideways - hatch, hatch), line_style(colour, 0.8));
}

void draw_centre_of_mass(SvgCanvas& canvas, PixelPoint at, const std::string& colour) {
  constexpr double radius = 5;
  canvas.circle(at, radius, "fill=\"white\" " + line_style(colour, 1));
  for (const double side : {1.0, -1.0}) {
    std::vector<PixelPoint> quarter = {at};
    for (int i = 0; i <= 8; ++i) {
      const double angle = foundation::two_pi / 4 * i / 8;
      quarter.push_back({at.x + side * radius * std::cos(angle), at.y - side * radius * std::sin(angle)});
    }
    canvas.area({quarter}, fmt::format("fill=\"{}\"", colour));
  }
}

void draw_point(SvgCanvas& canvas, PixelPoint at, const std::string& colour) {
  constexpr double half = 4;
  canvas.area({{{at.x - half, at.y}, {at.x, at.y - half}, {at.x + half, at.y}, {at.x, at.y + half}}},
              "fill=\"white\" " + line_style(colour, 1.2));
}

void draw_node(SvgCanvas& canvas, PixelPoint at, const std::string& colour) {
  canvas.rectangle({at.x - 2.6, at.y - 2.6}, 5.2, 5.2, fmt::format("fill=\"{}\"", colour));
}

void draw_arrow(SvgCanvas& canvas, PixelPoint from, PixelPoint to, int heads, const std::string& colour) {
  const auto [along, length] = course(from, to);
  if (length < seen_as_point) {
    canvas.circle(from, 5, "fill=\"white\" " + line_style(colour, 1.3));
    canvas.circle(from, 1.6, fmt::format("fill=\"{}\"", colour));
    return;
  }
  canvas.line(from, {to.x - 4 * along.x, to.y - 4 * along.y}, line_style(colour, 1.6));
  for (int i = 0; i < heads; ++i) draw_head(canvas, {to.x - 7 * i * along.x, to.y - 7 * i * along.y}, along, colour);
}

void draw_rotating(SvgCanvas& canvas, const Projection& projection, const Eigen::Vector3d& at,
                   const Eigen::Vector3d& axis, double radius, const std::string& colour) {
  const Eigen::Vector3d first = axis.unitOrthogonal(), second = axis.cross(first);
  std::vector<PixelPoint> arc;
  constexpr int steps = 36;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 0.75 * foundation::two_pi * i / steps;
    arc.push_back(projection.at(at + radius * (std::cos(angle) * first + std::sin(angle) * second)));
  }
  canvas.polyline(arc, line_style(colour, 1.6));
  draw_head(canvas, arc.back(), course(arc[steps - 3], arc.back()).along, colour);
  canvas.circle(projection.at(at), 1.8, fmt::format("fill=\"{}\"", colour));
}

void draw_ground_axes(SvgCanvas& canvas, const View& view, PixelPoint corner) {
  for (int axis = 0; axis < 3; ++axis) {
    const PixelPoint way{26 * view.right(axis), -26 * view.up(axis)};
    if (std::hypot(way.x, way.y) < 1) continue;
    const PixelPoint tip{corner.x + way.x, corner.y + way.y};
    canvas.line(corner, tip, line_style(drawing_ink, 1));
    draw_head(canvas, tip, course(corner, tip).along, drawing_ink);
    canvas.text({corner.x + 1.4 * way.x, corner.y + 1.4 * way.y + 4}, std::string(1, "xyz"[axis]),
                fmt::format("text-anchor=\"middle\" fill=\"{}\"", drawing_ink));
  }
}

}  // namespace trivet::report
