// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace trivet::numerics {

/// A zero of the slope of one curve in one lane, or an x near it.
struct FoundExtremum {
  int lane = 0;
  int channel = 0;
  double at = 0;     ///< x, ω² or ω
  double lower = 0;  ///< ends of its panel
  double upper = 0;
  bool maximum = false;
  double value = 0;   ///< half of |y|², after refinement
  double missed = 0;  ///< error of `value`: change by a further step, and round-off
};

using FoundExtrema = std::vector<FoundExtremum>;

}  // namespace trivet::numerics
