// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Time histories under the excitations of type time.
struct TransientQuestion : Question {
  double from = 0;             ///< [s]
  std::optional<double> to;    ///< [s]
  std::optional<double> step;  ///< [s]
  bool nearest_linear_system = false;
  std::vector<std::pair<std::string, double>> displacements,
      velocities;  ///< initial, by coordinate: "frame.z" [m, rad, m/s, rad/s]
};

}  // namespace trivet::project
