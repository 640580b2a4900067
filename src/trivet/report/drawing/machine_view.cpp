// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/machine_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/seen_surface.h"

namespace trivet::report {
namespace {

constexpr double arrow_length = 0.11, rotating_radius = 0.05;  // of the size of the machine
constexpr double font_size = 11;

/// Colours of a machine, or of a given design behind it.
struct Palette {
  const char *bodies, *springs, *forces, *fill;
  bool ground = true;  ///< the hatched lines below springs too
};
constexpr Palette clear = {drawing_ink, drawing_springs, drawing_forces, "#eef2f6"};
constexpr Palette faint = {drawing_faint, drawing_faint, drawing_faint, "none"};
constexpr Palette displaced = {drawing_moved, drawing_moved, drawing_moved, "none", false};

/// What is drawn of a solid.
SeenSurface outline_of(const DrawnMachine::Solid& solid, const Projection& projection) {
  constexpr std::size_t most_faces = 4000;  // of a surface that is drawn face by face
  if (solid.surface.faces.size() <= most_faces) return seen(solid.surface, projection);
  std::vector<PixelPoint> points;
  for (const Eigen::Vector3d& v : solid.surface.vertices) points.push_back(projection.at(v));
  SeenSurface outline;
  outline.faces = {convex_hull(points)};
  const std::vector<PixelPoint>& hull = outline.faces.front();
  for (std::size_t i = 0; i < hull.size(); ++i) outline.lines.emplace_back(hull[i], hull[(i + 1) % hull.size()]);
  return outline;
}

void draw_solid(SvgCanvas& canvas, const DrawnMachine::Solid& solid, const Projection& projection,
                const Palette& palette) {
  const SeenSurface outline = outline_of(solid, projection);
  if (std::string_view(palette.fill) != "none" && !solid.equivalent)
    for (const auto& face : outline.faces)
      canvas.area({face}, fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.5\"", palette.fill));
  for (const auto& [a, b] : outline.lines)
    canvas.line(a, b,
                fmt::format("stroke=\"{}\" stroke-width=\"1.1\" stroke-linecap=\"round\"{}", palette.bodies,
                            solid.equivalent ? " stroke-dasharray=\"6,4\"" : ""));
}

void draw_solids(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, const Palette& palette) {
  std::vector<std::pair<double, const DrawnMachine::Solid*>> far_to_near;
  for (const DrawnMachine::Solid& solid : machine.solids) {
    Bounds box;
    for (const Eigen::Vector3d& v : solid.surface.vertices) box.include(v);
    far_to_near.emplace_back(projection.view.towards().dot(box.centre()), &solid);
  }
  std::ranges::stable_sort(far_to_near, {}, &std::pair<double, const DrawnMachine::Solid*>::first);
  for (const auto& [depth, solid] : far_to_near) draw_solid(canvas, *solid, projection, palette);
}

/// From the bodies to their points and elements that are not on them.
std::vector<std::pair<PixelPoint, PixelPoint>> limbs_of(const DrawnMachine& machine, const Projection& projection) {
  std::vector<std::pair<PixelPoint, PixelPoint>> limbs;
  const auto limb = [&](std::size_t body, const Eigen::Vector3d& place) {
    if (machine.bodies[body].is_node) return;
    limbs.emplace_back(projection.at(machine.nearest_on(body, place)), projection.at(place));
  };
  for (const DrawnMachine::Element& element : machine.elements) {
    if (element.k_body) limb(*element.k_body, element.k);
    if (element.n_body) limb(*element.n_body, element.n);
  }
  for (const DrawnMachine::Point& point : machine.points) limb(point.body, point.at);
  return limbs;
}

void draw_limbs(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, const Palette& palette) {
  for (const auto& [from, to] : limbs_of(machine, projection))
    canvas.line(from, to, fmt::format("stroke=\"{}\" stroke-width=\"0.7\"", palette.bodies));
}

void draw_elements(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, double size,
                   const Palette& palette) {
  for (const DrawnMachine::Element& element : machine.elements) {
    const SpringLine line = spring_line(element, size);
    const PixelPoint n = projection.at(line.n), k = projection.at(line.k);
    if (palette.ground || element.support != DrawnMachine::Support::ground)
      draw_support(canvas, n, k, element.support, palette.bodies);
    if (element.is_beam) draw_beam(canvas, n, k, palette.springs);
    else draw_spring(canvas, n, k, palette.springs);
  }
}

void draw_excitations(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, double size) {
  for (const DrawnMachine::Excitation& e : machine.excitations) {
    const PixelPoint at = projection.at(e.at);
    if (e.rotation.norm() > 0)
      draw_rotating(canvas, projection, e.at, e.rotation, rotating_radius * size, drawing_forces);
    const auto arrow = [&](const Eigen::Vector3d& direction, int heads) {
      if (direction.norm() > 0)
        draw_arrow(canvas, at, projection.at(e.at + arrow_length * size * direction), heads, drawing_forces);
    };
    arrow(e.force, 1);
    arrow(e.moment, 2);
  }
}

/// A name with the order in which it gets its place, and the kind of thing among which places must differ.
struct Name {
  std::string text;
  Eigen::Vector3d at;
  std::size_t view;
};

std::vector<Name> names_of(const DrawnMachine& machine, double size, const project::DisplayUnits& display) {
  constexpr std::size_t front = 0, top = 2, isometric = 3;
  std::vector<Name> names;
  for (const DrawnMachine::Body& body : machine.bodies) {
    if (body.is_node) names.push_back({body.name, body.centre, top});
    else names.push_back({body.name + ", " + value_text(body.mass, display_unit(display, "kg")), body.centre, front});
  }
  for (const DrawnMachine::Point& point : machine.points) names.push_back({point.name, point.at, front});
  for (const DrawnMachine::Excitation& excitation : machine.excitations)
    names.push_back({excitation.name, excitation.at, front});
  for (const DrawnMachine::Element& element : machine.elements) {
    const SpringLine line = spring_line(element, size);
    names.push_back({element.name, (line.n + line.k) / 2, top});
  }
  for (const DrawnMachine::Foundation& foundation : machine.foundations)
    names.push_back({foundation.name, foundation.at, isometric});
  return names;
}

/// Moves names whose places coincide in their view into the isometric one.
void spread(std::vector<Name>& names, double scale) {
  constexpr double apart = 6, isometric = 3;  // [pixels]
  std::vector<bool> moves(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (names[i].view != names[j].view) continue;
      const View& view = four_views()[names[i].view];
      const Eigen::Vector3d d = scale * (names[i].at - names[j].at);
      if (std::hypot(view.right.dot(d), view.up.dot(d)) < apart) moves[i] = true;
    }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (moves[i]) names[i].view = static_cast<std::size_t>(isometric);
}

/// Rectangles that names keep free: symbols, the title of the view and its axes.
std::vector<Box> marks_of(const DrawnMachine& machine, const Projection& projection, const Box& area, double size) {
  std::vector<Box> marks = {{area.left, area.top, area.left + 80, area.top + 24},
                            {area.left, area.bottom - 78, area.left + 78, area.bottom}};
  const auto around = [&](const Eigen::Vector3d& place, double half) {
    const PixelPoint p = projection.at(place);
    marks.push_back({p.x - half, p.y - half, p.x + half, p.y + half});
  };
  for (const DrawnMachine::Body& body : machine.bodies) around(body.centre, body.is_node ? 3 : 6);
  for (const DrawnMachine::Point& point : machine.points) around(point.at, 5);
  for (const DrawnMachine::Element& element : machine.elements) {
    const SpringLine line = spring_line(element, size);
    constexpr int parts = 4;
    for (int i = 0; i <= (element.is_beam ? 0 : parts); ++i) around(line.n + (line.k - line.n) * i / parts, 6);
  }
  for (const DrawnMachine::Excitation& e : machine.excitations)
    for (const Eigen::Vector3d& direction : {e.force, e.moment})
      for (int i = 0; i <= 3; ++i) around(e.at + arrow_length * size * direction * i / 3, 5);
  return marks;
}

/// Symbols, which names keep free, and the outlines of the bodies, which would strike names through.
Obstacles obstacles_of(const DrawnMachine& machine, const Projection& projection, const Box& area, double size) {
  Obstacles obstacles{marks_of(machine, projection, area, size), limbs_of(machine, projection)};
  for (const DrawnMachine::Solid& solid : machine.solids)
    for (const auto& line : outline_of(solid, projection).lines) obstacles.lines.push_back(line);
  return obstacles;
}

}  // namespace

SpringLine spring_line(const DrawnMachine::Element& element, double size) {
  constexpr double shortest = 0.03, symbol = 0.085;  // of the size of the machine
  const double length = symbol * size;
  if ((element.k - element.n).norm() > shortest * size) return {element.n, element.k};
  if (element.support == DrawnMachine::Support::body)
    return {element.k - length / 2 * element.axis, element.k + length / 2 * element.axis};
  return {element.k - length * element.axis, element.k};
}

void draw_machine(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, double size) {
  draw_limbs(canvas, machine, projection, clear);
  draw_solids(canvas, machine, projection, clear);
  draw_elements(canvas, machine, projection, size, clear);
  for (const DrawnMachine::Point& point : machine.points) draw_point(canvas, projection.at(point.at), drawing_ink);
  draw_excitations(canvas, machine, projection, size);
  for (const DrawnMachine::Body& body : machine.bodies)
    (body.is_node ? draw_node : draw_centre_of_mass)(canvas, projection.at(body.centre), drawing_ink);
}

void draw_faint_machine(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, double size) {
  draw_limbs(canvas, machine, projection, faint);
  draw_solids(canvas, machine, projection, faint);
  draw_elements(canvas, machine, projection, size, faint);
  for (const DrawnMachine::Point& point : machine.points) draw_point(canvas, projection.at(point.at), drawing_faint);
}

void draw_moved_machine(SvgCanvas& canvas, const DrawnMachine& moved, const Projection& projection) {
  draw_limbs(canvas, moved, projection, displaced);
  draw_solids(canvas, moved, projection, displaced);
  draw_elements(canvas, moved, projection, 0, displaced);
  for (const DrawnMachine::Point& point : moved.points) draw_point(canvas, projection.at(point.at), drawing_moved);
  for (const DrawnMachine::Body& body : moved.bodies)
    if (body.is_node) draw_node(canvas, projection.at(body.centre), drawing_moved);
}

std::vector<std::string> draw_names(SvgCanvas& canvas, const DrawnMachine& machine, std::size_t view,
                                    const Projection& projection, const Box& area, double size,
                                    const project::DisplayUnits& display) {
  std::vector<Name> names = names_of(machine, size, display);
  spread(names, projection.scale);
  std::vector<Label> labels;
  for (const Name& name : names)
    if (name.view == view) labels.push_back({name.text, projection.at(name.at)});
  constexpr double edge = 4;
  const Box inside{area.left + edge, area.top + edge, area.right - edge, area.bottom - edge};
  const auto placed = placed_labels(labels, inside, obstacles_of(machine, projection, area, size), font_size);
  std::vector<std::string> left_out;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!placed[i]) {
      left_out.push_back(labels[i].text);
      continue;
    }
    constexpr double near = 10;
    const PixelPoint place = labels[i].place, leader = placed[i]->leader;
    if (std::hypot(leader.x - place.x, leader.y - place.y) > near)
      canvas.line(place, leader, "stroke=\"#666\" stroke-width=\"0.6\"");
    canvas.text(placed[i]->baseline, labels[i].text,
                fmt::format("fill=\"{}\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"", drawing_ink));
  }
  return left_out;
}

}  // namespace trivet::report
