// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::assembly {

/// A limit over frequency: straight lines between its points on logarithmic axes, undefined outside them. Two points of
/// equal frequency form a step; there the lower limit applies.
struct LimitLine {
  std::string name;
  std::string unit;                       ///< SI, of the result it limits: "m", "m/s", "m/s²", "N" …
  bool rms = true;                        ///< root mean square; otherwise zero-to-peak
  std::vector<double> angular_frequency;  ///< [rad/s] > 0, ascending
  std::vector<double> limit;              ///< > 0
};

/// All errors of the table; `subject` is its path in the project.
[[nodiscard]] foundation::Problems check(const LimitLine& line, const std::string& subject);

}  // namespace trivet::assembly
