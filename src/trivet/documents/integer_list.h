// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/documents/json_text.h"

namespace trivet::documents::json {

/// A list of whole numbers on one line, without points.
[[nodiscard]] Json integer_list(const std::vector<int>& values);

}  // namespace trivet::documents::json
