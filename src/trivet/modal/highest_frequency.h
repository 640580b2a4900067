// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"

namespace trivet::modal {

/// Highest natural frequency of a system [rad/s], growing motions included; 1 if all are 0.
[[nodiscard]] double highest_natural_frequency(const model::System& system, const assembly::Assembled& assembled);

}  // namespace trivet::modal
