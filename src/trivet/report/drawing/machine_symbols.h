// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/report/drawing/view_projection.h"

/// Symbols of a machine drawing, as engineers use them. All lengths [pixels].
namespace trivet::report {

inline constexpr const char* drawing_ink = "#333";         ///< bodies, points, text
inline constexpr const char* drawing_faint = "#b5b5b5";    ///< the given design behind another one; a machine at rest
inline constexpr const char* drawing_moved = "#0072B2";    ///< a displaced machine
inline constexpr const char* drawing_springs = "#0072B2";  ///< elastic elements
inline constexpr const char* drawing_forces = "#D55E00";   ///< excitations

/// Zigzag from `a` to `b`; seen along its axis two circles.
void draw_spring(SvgCanvas& canvas, PixelPoint a, PixelPoint b, const std::string& colour, double width = 1.3);
void draw_beam(SvgCanvas& canvas, PixelPoint a, PixelPoint b, const std::string& colour);

/// The ground at the end `at` of a spring that comes from `from`: a hatched line; a double line for a flexible
/// foundation. Nothing for an end on a body.
void draw_support(SvgCanvas& canvas, PixelPoint at, PixelPoint from, DrawnMachine::Support support,
                  const std::string& colour);

/// Circle with two filled quarters.
void draw_centre_of_mass(SvgCanvas& canvas, PixelPoint at, const std::string& colour);
void draw_point(SvgCanvas& canvas, PixelPoint at, const std::string& colour);
void draw_node(SvgCanvas& canvas, PixelPoint at, const std::string& colour);

/// Arrow with one head, or two for a moment; seen along its axis a circle with a dot.
void draw_arrow(SvgCanvas& canvas, PixelPoint from, PixelPoint to, int heads, const std::string& colour);
/// Three quarters of a circle about an axis, with a head. @param radius  in the ground frame [m]
void draw_rotating(SvgCanvas& canvas, const Projection& projection, const Eigen::Vector3d& at,
                   const Eigen::Vector3d& axis, double radius, const std::string& colour);

/// Ground axes x, y, z from a corner.
void draw_ground_axes(SvgCanvas& canvas, const View& view, PixelPoint corner);

}  // namespace trivet::report
