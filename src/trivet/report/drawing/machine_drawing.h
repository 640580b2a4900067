// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/project.h"

namespace trivet::report {

/// Drawing of a machine as SVG: front, side, top and isometric view at one scale, with names, axes and a scale bar.
/// Bodies are drawn by their solids, or by the box of equal mass and inertia, dashed. A name is written in the view
/// that shows its place best.
[[nodiscard]] std::string machine_drawing(const project::Case& machine);

/// The same with the views below each other, for narrow screens.
[[nodiscard]] std::string narrow_machine_drawing(const project::Case& machine);

/// The same of a design, over a given one in grey.
[[nodiscard]] std::string machine_drawing(const project::Case& given, const project::Case& design);

}  // namespace trivet::report
