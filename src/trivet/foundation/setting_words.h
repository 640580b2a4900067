// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "trivet/foundation/problems.h"

namespace trivet::foundation {

/// Begin of the source of a setting, in the words of the command line: "--set elements.mount.scale=2".
inline constexpr std::string_view setting_source = "--set ";

/// The problem with the word of another caller for settings: "changes: elements.mount.scale=2".
[[nodiscard]] Problem with_word_of_settings(Problem problem, std::string_view word);

}  // namespace trivet::foundation
