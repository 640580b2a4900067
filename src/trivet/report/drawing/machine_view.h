// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/display_units.h"
#include "trivet/report/drawing/label_placement.h"
#include "trivet/report/drawing/machine_symbols.h"

namespace trivet::report {

/// Draws a machine in one view: bodies from far to near, then elements, points, centres of mass and excitations.
/// @param size  of the machine [m]
void draw_machine(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, double size);

/// Draws its bodies, elements and points in grey, without names.
void draw_faint_machine(SvgCanvas& canvas, const DrawnMachine& machine, const Projection& projection, double size);

/// Draws its bodies, elements and points displaced, in colour over the machine at rest.
/// @param moved  elements end where their symbols do
void draw_moved_machine(SvgCanvas& canvas, const DrawnMachine& moved, const Projection& projection);

/// Writes the names that belong into a view: bodies, points and excitations into the front view, elements and nodes
/// into the top view, foundations and what coincides there into the isometric one.
/// @param view  place in `four_views()`
/// @returns the names for which there is no room
[[nodiscard]] std::vector<std::string> draw_names(SvgCanvas& canvas, const DrawnMachine& machine, std::size_t view,
                                                  const Projection& projection, const Box& area, double size,
                                                  const project::DisplayUnits& display);

/// Ends of the spring symbol of an element: its ends, or a short line along its axis if they are at one place.
struct SpringLine {
  Eigen::Vector3d n, k;
};
[[nodiscard]] SpringLine spring_line(const DrawnMachine::Element& element, double size);

}  // namespace trivet::report
