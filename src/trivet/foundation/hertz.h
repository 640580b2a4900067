// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/foundation/constants.h"

namespace trivet::foundation {

/// [Hz] of ω [rad/s].
[[nodiscard]] inline double hertz(double omega) { return omega / two_pi; }

/// ω [rad/s] in the words of a message: "16.33 Hz".
[[nodiscard]] std::string hertz_words(double omega, int digits = 4);

/// "20 … 26 Hz"
[[nodiscard]] std::string hertz_range(double from, double to, int digits = 4);

}  // namespace trivet::foundation
