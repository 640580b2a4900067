// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::results {

/// "displacement" for m, "moment" for N m …; the unit itself if it has no such name.
[[nodiscard]] std::string quantity_name(const std::string& unit);

}  // namespace trivet::results
