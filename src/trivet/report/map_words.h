// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/design_map.h"

namespace trivet::report {

/// What an axis is called: its name, or what its path means in the field's words ("stiffness scale of suspension").
[[nodiscard]] std::string axis_name(const study::MapAxis& axis);

/// The same with its unit in brackets.
[[nodiscard]] std::string axis_label(const study::MapAxis& axis);

/// "0.12 s"
[[nodiscard]] std::string value_words(double value, const study::MapAxis& axis);

/// Why cases stand nowhere on the picture, one sentence for each reason; empty if all do.
[[nodiscard]] std::vector<std::string> undrawn_cases(const study::DesignMap& map);

/// Is a mark drawn: a design of this map inside its frame?
[[nodiscard]] bool is_drawn(const study::DesignMap& map, const study::MapMark& mark);

}  // namespace trivet::report
