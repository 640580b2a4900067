// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Periodic motions of a nonlinear machine under its harmonic excitations, over their frequency.
struct SteadyQuestion : BandQuestion {
  int harmonics = 0;        ///< 0: as many as `tolerance` needs
  double tolerance = 1e-3;  ///< share of the deflections that harmonics beyond the last one may add
};

}  // namespace trivet::project
