// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/response/random/random_response.h"

namespace trivet::study {

/// √Σ (k a_w)² over the axes that people feel, of one body or point. [ISO 2631-1:1997 section 8.2]
struct TotalValue {
  std::string name;
  double value = 0;  ///< [m/s²]
  std::vector<std::string>
      axes;  ///< "x" … "rz": x, y, z, and the rotations that were asked for and have a factor at this contact
};

struct RandomResult {
  response::RandomResponse response;
  response::RandomCurves curves;         ///< densities [unit²/(rad/s)]
  std::vector<std::string> inputs;       ///< of the variance shares
  std::vector<TotalValue> total_values;  ///< where a contact with people is given
  assembly::Quantity quantity = assembly::Quantity::displacement;
};

}  // namespace trivet::study
