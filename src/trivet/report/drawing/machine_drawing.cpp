// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/machine_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/drawing_legend.h"
#include "trivet/report/drawing/machine_view.h"

namespace trivet::report {
namespace {

constexpr double paper_width = 980, most_height = 820;
constexpr double narrow_width = 400, most_height_of_view = 300;
constexpr double side_room = 105, room_above = 44, room_below = 46;  // of each view, for names and axes
constexpr double narrow_side_room = 90;
constexpr double legend_height = 40;

/// Half width and half height of the machine in a view [m].
struct HalfSize {
  double width, height;
};

HalfSize half_size(const View& view, const Bounds& bounds) {
  const Eigen::Vector3d half = (bounds.high - bounds.low) / 2;
  return {view.right.cwiseAbs().dot(half), view.up.cwiseAbs().dot(half)};
}

/// Places of the four views.
struct Sheet {
  double scale = 1;                                           ///< [pixels/m]
  double width = 0, height = 0;                               ///< [pixels]
  std::array<Box, 4> areas = {};                              ///< of front, side, top, isometric
  std::vector<std::pair<PixelPoint, PixelPoint>> lines = {};  ///< between the views
};

/// The top view is above the front view, the side view beside it.
Sheet square_sheet(const Bounds& bounds) {
  std::array<HalfSize, 4> halves{};
  for (std::size_t v = 0; v < 4; ++v) halves[v] = half_size(four_views()[v], bounds);
  const auto& [front, side, top, isometric] = halves;
  const double widths = 2 * (std::max(front.width, top.width) + std::max(side.width, isometric.width));
  const double heights = 2 * (std::max(front.height, side.height) + std::max(top.height, isometric.height));
  const double rooms = 2 * (room_above + room_below);
  Sheet s{.width = paper_width};
  s.scale = std::min((paper_width - 4 * side_room) / widths, (most_height - rooms) / heights);
  const double spare = (paper_width - s.scale * widths) / 2;
  const double left = 2 * s.scale * std::max(front.width, top.width) + spare;
  const auto height = [&](const HalfSize& a, const HalfSize& b) {
    constexpr double least = 190;
    return std::max(least, 2 * s.scale * std::max(a.height, b.height) + room_above + room_below);
  };
  const double above = height(top, isometric);
  s.height = above + height(front, side);
  const Box upper{0, 0, left, above}, lower{0, above, left, s.height};
  s.areas = {lower, Box{left, lower.top, paper_width, lower.bottom}, upper, Box{left, 0, paper_width, upper.bottom}};
  s.lines = {{{left, 10}, {left, s.height - 6}}, {{10, above}, {paper_width - 10, above}}};
  return s;
}

/// The top view is above the front view, then follow the side and the isometric view.
Sheet column_sheet(const Bounds& bounds) {
  std::array<HalfSize, 4> halves{};
  double width = 0, height = 0;
  for (std::size_t v = 0; v < 4; ++v) {
    halves[v] = half_size(four_views()[v], bounds);
    width = std::max(width, 2 * halves[v].width);
    height = std::max(height, 2 * halves[v].height);
  }
  Sheet s{.width = narrow_width};
  s.scale = std::min((narrow_width - 2 * narrow_side_room) / width, most_height_of_view / height);
  constexpr std::size_t front = 0, side = 1, top = 2, isometric = 3;
  for (const std::size_t v : {top, front, side, isometric}) {
    constexpr double least = 160;
    const double end = s.height + std::max(least, 2 * s.scale * halves[v].height + room_above + room_below);
    s.areas[v] = {0, s.height, narrow_width, end};
    if (v != isometric) s.lines.push_back({{10, end}, {narrow_width - 10, end}});
    s.height = end;
  }
  return s;
}

std::string drawn(const DrawnMachine& machine, const DrawnMachine* given, const project::DisplayUnits& display,
                  const std::string& description, Sheet (*sheet)(const Bounds&) = square_sheet) {
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
  SvgCanvas canvas(s.width, s.height + legend_height);
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
  for (const auto& [from, to] : s.lines) canvas.line(from, to, "stroke=\"#e4e4e4\"");
  canvas.reach(
      draw_drawing_legend(canvas, {14, s.height + 14}, s.width, machine, given != nullptr, s.scale, display, left_out));
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

std::string narrow_machine_drawing(const project::Case& machine) {
  return drawn(results::drawn_machine(machine), nullptr, machine.display, described(machine), column_sheet);
}

std::string machine_drawing(const project::Case& given, const project::Case& design) {
  const DrawnMachine before = results::drawn_machine(given);
  return drawn(results::drawn_machine(design), &before, design.display, described(design));
}

}  // namespace trivet::report
