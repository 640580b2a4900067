// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Shock response spectra of time excitations.
struct ShockSpectrumQuestion : Question {
  double damping_ratio = 0.05;
  assembly::Band band;  ///< of natural frequencies [rad/s]
};

}  // namespace trivet::project
