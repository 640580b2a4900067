// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Parses TOML text. `source` names it in messages. Nesting and dotted keys deeper than 64 are rejected.
[[nodiscard]] foundation::Expected<Node> parse_toml(std::string_view text, const std::string& source);

}  // namespace trivet::project
