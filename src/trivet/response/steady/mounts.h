// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"

namespace trivet::response {

/// Elements whose end N stands on the ground or on a foundation that gives; the impedance of a ground point is none
/// itself.
[[nodiscard]] std::vector<std::size_t> mounts(const model::System& system);

}  // namespace trivet::response
