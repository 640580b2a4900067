// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/plot_panel.h"
#include "trivet/study/design_map.h"

namespace trivet::report {

/// What an axis is called, with its unit in brackets.
[[nodiscard]] std::string axis_label(const project::MapAxis& axis);

/// The axis as pictures draw it: one that is short beside its numbers counts from its beginning, and its label says so.
[[nodiscard]] Axis drawn_axis(const project::MapAxis& axis);

/// Why cases stand nowhere on the picture, with their verdicts, one sentence for each reason; empty if all do.
[[nodiscard]] std::vector<std::string> undrawn_cases(const study::DesignMap& map);

/// Warnings of the map, a sentence each.
[[nodiscard]] std::vector<std::string> doubts(const study::DesignMap& map);

/// Is a mark drawn: a design of this map inside its frame?
[[nodiscard]] bool is_drawn(const study::DesignMap& map, const study::MapMark& mark);

}  // namespace trivet::report
