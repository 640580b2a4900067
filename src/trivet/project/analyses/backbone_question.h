// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Nonlinear modes: free periodic motions over their amplitude.
struct BackboneQuestion : Question {
  std::vector<int> modes = {1};  ///< of the machine about rest, from 1
  /// Largest deflection of any nonlinear part, translations [m] and rotations [rad], and largest energy [J].
  double up_to = std::numeric_limits<double>::infinity(), up_to_angle = std::numeric_limits<double>::infinity(),
         up_to_energy = std::numeric_limits<double>::infinity();
  bool damped = false;
  int harmonics = 0;        ///< 0: as many as `tolerance` needs
  double tolerance = 1e-3;  ///< share of the deflections that harmonics beyond the last one may add
};

}  // namespace trivet::project
