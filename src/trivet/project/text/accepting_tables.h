// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::project {

/// Tables that may have a key `accept`, about themselves.
inline constexpr const char* accepting_tables[] = {"damping", "limits", "requirements", "operation"};
/// Tables of tables that may have one.
inline constexpr const char* holders_of_accepting_tables[] = {"bodies",      "elements", "excitations",
                                                              "foundations", "analyses", "limit_lines"};

/// True if the table at this path may have a key `accept`; false for the top of the file, which may have one too.
[[nodiscard]] bool may_accept(const std::string& path);

}  // namespace trivet::project
