// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/plot_panel.h"
#include "trivet/study/map/design_map.h"

namespace trivet::report {

/// Name of an axis, with its unit in brackets.
[[nodiscard]] std::string axis_label(const project::DesignAxis& axis);

/// The axis as drawn in pictures: one that is short compared with its numbers starts at 0, and its label shows the
/// offset.
[[nodiscard]] Axis drawn_axis(const project::DesignAxis& axis);

/// Cases that are not in the picture, with their verdicts, one sentence for each reason; empty if all are drawn.
[[nodiscard]] std::vector<std::string> undrawn_cases(const study::DesignMap& map);

/// Warnings of the map, one sentence each.
[[nodiscard]] std::vector<std::string> doubts(const study::DesignMap& map);

/// Is a mark drawn, as a design of this map inside its frame?
[[nodiscard]] bool is_drawn(const study::DesignMap& map, const study::MapMark& mark);

}  // namespace trivet::report
