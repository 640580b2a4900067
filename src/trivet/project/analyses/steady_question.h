// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Periodic motions of a nonlinear machine under its harmonic excitations, over their frequency or their load factor.
struct SteadyQuestion : BandQuestion {
  bool over_load_factor = false;
  double at = 0;  ///< over the load factor: the fixed ω [rad/s]
  double load_from = 0, load_to = 0;
  std::string phase_of;       ///< or, over the load factor, at the frequency where this result lags; empty: at `at`
  double lag = 0;             ///< by this phase [rad]
  int harmonics = 0;          ///< 0: as many as `tolerance` needs
  bool all_branches = false;  ///< seek detached motions too
  bool deep = false;          ///< judge the stability of every point in two ways
  std::vector<double> harmonics_at = {};  ///< tell the harmonics of all motions there [rad/s]
  double tolerance = 1e-3;                ///< share of the deflections that harmonics beyond the last one may add
};

}  // namespace trivet::project
