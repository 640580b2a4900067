// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"

namespace trivet::response {

/// Elements with end N on the ground or on a flexible foundation; the impedance of a ground point is not a mount.
[[nodiscard]] std::vector<std::size_t> mounts(const model::System& system);

}  // namespace trivet::response
