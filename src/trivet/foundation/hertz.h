// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/constants.h"

namespace trivet::foundation {

/// [Hz] of ω [rad/s].
[[nodiscard]] inline double hertz(double omega) { return omega / two_pi; }

}  // namespace trivet::foundation
