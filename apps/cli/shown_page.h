// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::cli {

/// Shows a page in the program of BROWSER, or by xdg-open, and waits until that returns.
/// @returns why it is not shown; empty if it is
[[nodiscard]] std::string show_page(const std::string& file);

}  // namespace trivet::cli
