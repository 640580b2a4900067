// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"

namespace trivet::modal {

/// The highest natural frequency of a system [rad/s], also of motions that grow; 1 where nothing holds it.
[[nodiscard]] double highest_natural_frequency(const model::System& system, const assembly::Assembled& assembled);

}  // namespace trivet::modal
