// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Operating deflection shapes at single frequencies.
struct ShapesQuestion : Question {
  std::vector<double> at;  ///< [rad/s]
};

}  // namespace trivet::project
