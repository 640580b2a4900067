// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// A text as a TOML string.
[[nodiscard]] std::string toml_string(const std::string& text);

/// A value as the project file has it, numbers by their shortest text of equal value: 1.5, "3 kN/m", [1, 2],
/// {loss_factor = 0.1}.
[[nodiscard]] std::string toml_value(const Node& node);

/// Changes as settings: "elements.\"front left\".scale = 1.5", one per value, with all digits.
[[nodiscard]] std::vector<std::string> setting_words(const std::vector<Node>& changes);

}  // namespace trivet::project
