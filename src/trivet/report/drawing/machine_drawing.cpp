// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/machine_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/drawing_legend.h"
#include "trivet/report/drawing/machine_view.h"

namespace trivet::report {
namespace {

constexpr double paper_width = 980, most_height = 820;
constexpr double side_room = 105, room_above = 44, room_below = 46;  // of each view, for names and axes
constexpr double legend_height = 40;

/// Half width and half height of the machine in a view [m].
struct HalfSize {
  double width, height;
};

HalfSize half_size(const View& view, const Bounds& bounds) {
  const Eigen::Vector3d half = (bounds.high - bounds.low) / 2;
  return {view.right.cwiseAbs().dot(half), view.up.cwiseAbs().dot(half)};
}

/// Rows and columns of the four views: the top view is above the front view, the side view beside it.
struct Sheet {
  double scale;              ///< [pixels/m]
  double left, right;        ///< widths of the columns
  double above, below;       ///< heights of the rows
  std::array<Box, 4> areas;  ///< of front, side, top, isometric
};

Sheet sheet(const Bounds& bounds) {
  std::array<HalfSize, 4> halves{};
  for (std::size_t v = 0; v < 4; ++v) halves[v] = half_size(four_views()[v], bounds);
  const auto& [front, side, top, isometric] = halves;
  const double widths = 2 * (std::max(front.width, top.width) + std::max(side.width, isometric.width));
  const double heights = 2 * (std::max(front.height, side.height) + std::max(top.height, isometric.height));
  const double rooms = 2 * (room_above + room_below);
  Sheet s{};
  s.scale = std::min((paper_width - 4 * side_room) / widths, (most_height - rooms) / heights);
  const double spare = (paper_width - s.scale * widths) / 2;
  s.left = 2 * s.scale * std::max(front.width, top.width) + spare;
  s.right = paper_width - s.left;
  const auto height = [&](const HalfSize& a, const HalfSize& b) {
    constexpr double least = 190;
    return std::max(least, 2 * s.scale * std::max(a.height, b.height) + room_above + room_below);
  };
  s.above = height(top, isometric);
  s.below = height(front, side);
  const Box upper{0, 0, s.left, s.above}, lower{0, s.above, s.left, s.above + s.below};
  s.areas = {lower, Box{s.left, lower.top, paper_width, lower.bottom}, upper,
             Box{s.left, 0, paper_width, upper.bottom}};
  return s;
}

std::string drawn(const DrawnMachine& machine, const DrawnMachine* given, const project::DisplayUnits& display,
                  const std::string& description) {
  Bounds bounds = machine.bounds();
  if (given)
    for (const Eigen::Vector3d& corner : {given->bounds().low, given->bounds().high}) bounds.include(corner);
  constexpr double least_size = 0.05;  // of a machine whose places all coincide [m]
  if (bounds.size() < least_size) {
    const Eigen::Vector3d centre = bounds.centre();
    bounds.include(centre - Eigen::Vector3d::Constant(least_size / 2));
    bounds.include(centre + Eigen::Vector3d::Constant(least_size / 2));
  }
  const Sheet s = sheet(bounds);
  SvgCanvas canvas(paper_width, s.above + s.below + legend_height);
  std::vector<std::string> left_out;
  for (std::size_t v = 0; v < 4; ++v) {
    const Box& area = s.areas[v];
    const PixelPoint middle{(area.left + area.right) / 2, (area.top + area.bottom + room_above - room_below) / 2};
    const Projection projection{four_views()[v], s.scale, bounds.centre(), middle};
    if (given) draw_faint_machine(canvas, *given, projection, bounds.size());
    draw_machine(canvas, machine, projection, bounds.size());
    const PixelPoint corner{area.left + 26, area.bottom - 26};
    canvas.text({area.left + 10, area.top + 18}, four_views()[v].name,
                fmt::format("font-weight=\"bold\" fill=\"{}\"", drawing_ink));
    draw_ground_axes(canvas, four_views()[v], corner);
    for (std::string& name : draw_names(canvas, machine, v, projection, area, bounds.size(), display))
      left_out.push_back(std::move(name));
  }
  canvas.line({s.left, 10}, {s.left, s.above + s.below - 6}, "stroke=\"#e4e4e4\"");
  canvas.line({10, s.above}, {paper_width - 10, s.above}, "stroke=\"#e4e4e4\"");
  draw_drawing_legend(canvas, {14, s.above + s.below + 14}, machine, given != nullptr, s.scale, display, left_out);
  return canvas.svg(description);
}

std::string described(const project::Case& machine) {
  return machine.system.description().title.empty() ? "Drawing of the machine"
                                                    : "Drawing of " + machine.system.description().title;
}

}  // namespace

std::string machine_drawing(const project::Case& machine) {
  return drawn(results::drawn_machine(machine), nullptr, machine.display, described(machine));
}

std::string machine_drawing(const project::Case& given, const project::Case& design) {
  const DrawnMachine before = results::drawn_machine(given);
  return drawn(results::drawn_machine(design), &before, design.display, described(design));
}

}  // namespace trivet::report
