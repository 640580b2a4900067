// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/excitation/signal.h"
#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// A measured time history: values at increasing times [s], linear between them, zero before the first.
struct Samples {
  enum class Afterwards { hold, zero };
  std::vector<double> times;
  std::vector<double> values;
  Afterwards afterwards = Afterwards::hold;  ///< what follows the last sample
};

/// Errors: unequal counts, fewer than two, numbers not finite, times that do not increase. Warnings: a first value that
/// is not 0 (the signal jumps), a last one that is not 0 (it is held, or falls to zero with a jump).
[[nodiscard]] foundation::Problems check(const Samples& samples, const std::string& subject);

/// @throws foundation::InvalidInput with the first error of `check`
[[nodiscard]] Signal from_samples(const Samples& samples);

}  // namespace trivet::excitation
