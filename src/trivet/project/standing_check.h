// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"

namespace trivet::project {

/// Does the machine stand? An error if its weight makes it fall over; of a nonlinear machine, whose forces may hold it
/// farther away, a warning.
[[nodiscard]] foundation::Problems standing_problems(const model::System& system);

}  // namespace trivet::project
