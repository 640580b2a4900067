// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/response/random/random_response.h"

namespace trivet::study {

/// Vibration total value √Σ (k a_w)² of one body or point, over the axes with a factor k. [ISO 2631-1:1997 section 8.2]
struct TotalValue {
  std::string name;
  double value = 0;  ///< [m/s²]
  std::vector<std::string>
      axes;  ///< "x" … "rz": x, y, z, and the requested rotations that have a factor at this contact
};

struct RandomResult {
  response::RandomResponse response;
  response::RandomCurves curves;         ///< densities [unit²/(rad/s)]
  std::vector<std::string> inputs;       ///< inputs of the variance shares
  std::vector<TotalValue> total_values;  ///< if a contact with people is given
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
};

}  // namespace trivet::study
