// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/drawing_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/label_placement.h"

namespace trivet::report {
namespace {

struct Entry {
  bool is_used;
  std::string words;
  std::function<void(PixelPoint)> symbol;  ///< drawn in the 22 pixels right of a place
};

std::vector<Entry> entries(SvgCanvas& canvas, const DrawnMachine& machine, bool over_given) {
  using Element = DrawnMachine::Element;
  using Support = DrawnMachine::Support;
  const auto element = [&](auto&& rule) { return std::ranges::any_of(machine.elements, rule); };
  const auto carried = [&](Support by) { return element([by](const Element& e) { return e.support == by; }); };
  const auto body = [&](bool node) {
    return std::ranges::any_of(machine.bodies, [node](const DrawnMachine::Body& b) { return b.is_node == node; });
  };
  const bool equivalent = std::ranges::any_of(machine.solids, &DrawnMachine::Solid::equivalent);
  const auto support = [&canvas](Support by) {
    return [&canvas, by](PixelPoint p) { draw_support(canvas, {p.x + 11, p.y}, {p.x + 11, p.y - 8}, by, drawing_ink); };
  };
  return {
      {body(false), "centre of mass", [&](PixelPoint p) { draw_centre_of_mass(canvas, {p.x + 11, p.y}, drawing_ink); }},
      {equivalent, "box of equal mass and inertia",
       [&](PixelPoint p) {
         canvas.rectangle({p.x, p.y - 5}, 20, 10, "fill=\"none\" stroke=\"#333\" stroke-dasharray=\"4,3\"");
       }},
      {element([](const Element& e) { return !e.is_beam; }), "elastic element",
       [&](PixelPoint p) { draw_spring(canvas, p, {p.x + 22, p.y}, drawing_springs); }},
      {element([](const Element& e) { return e.is_beam; }), "beam",
       [&](PixelPoint p) { draw_beam(canvas, p, {p.x + 20, p.y}, drawing_springs); }},
      {carried(Support::ground), "ground", support(Support::ground)},
      {carried(Support::foundation), "flexible foundation", support(Support::foundation)},
      {body(true), "node", [&](PixelPoint p) { draw_node(canvas, {p.x + 11, p.y}, drawing_ink); }},
      {!machine.points.empty(), "point", [&](PixelPoint p) { draw_point(canvas, {p.x + 11, p.y}, drawing_ink); }},
      {!machine.excitations.empty(), "excitation",
       [&](PixelPoint p) { draw_arrow(canvas, p, {p.x + 20, p.y}, 1, drawing_forces); }},
      {over_given, "given design",
       [&](PixelPoint p) { canvas.line(p, {p.x + 20, p.y}, "stroke=\"#b5b5b5\" stroke-width=\"2\""); }},
  };
}

}  // namespace

ScaleBar scale_bar(double scale, double wanted, const project::DisplayUnits& display) {
  const DisplayUnit unit = display_unit(display, "m");
  const UnitPrefix shown = unit_prefix(wanted / scale, unit);
  const double room = wanted / scale * shown.factor, power = std::pow(10.0, std::floor(std::log10(room)));
  const double length = room >= 5 * power ? 5 * power : room >= 2 * power ? 2 * power : power;
  return {length / shown.factor * scale, fmt::format("{:g} {}", length, shown.unit)};
}

double draw_drawing_legend(SvgCanvas& canvas, PixelPoint corner, double right, const DrawnMachine& machine,
                           bool over_given, double scale, const project::DisplayUnits& display,
                           const std::vector<std::string>& left_out) {
  constexpr double font = 11, wanted_bar = 110, symbol = 26, gap = 16;
  const ScaleBar bar = scale_bar(scale, wanted_bar, display);
  const std::string ink = fmt::format("stroke=\"{}\" stroke-width=\"1.2\"", drawing_ink);
  canvas.line(corner, {corner.x + bar.pixels, corner.y}, ink);
  for (const double end : {0.0, bar.pixels})
    canvas.line({corner.x + end, corner.y - 4}, {corner.x + end, corner.y + 4}, ink);
  canvas.text({corner.x + bar.pixels / 2, corner.y + 15}, bar.label,
              fmt::format("text-anchor=\"middle\" fill=\"{}\"", drawing_ink));
  const double start = corner.x + wanted_bar + 2 * gap;
  double x = start, y = corner.y;
  std::vector<Entry> used = entries(canvas, machine, over_given);
  std::erase_if(used, [](const Entry& entry) { return !entry.is_used; });
  if (!left_out.empty())
    used.push_back({true, fmt::format("{} names have no room: see the tables", left_out.size()), {}});
  for (const Entry& entry : used) {
    const double width = symbol + text_width(entry.words, font) + gap;
    if (x > start && x + width > right) {
      x = start;
      y += 18;
    }
    if (entry.symbol) entry.symbol({x, y});
    canvas.text({x + symbol, y + 4}, entry.words, fmt::format("fill=\"{}\"", drawing_ink));
    x += width;
  }
  constexpr double below = 22;  // of a baseline: the label of the scale bar
  return y + below;
}

}  // namespace trivet::report
