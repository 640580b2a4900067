// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/nonlinear/balance/harmonic_balance.h"

namespace trivet::nonlinear {

/// Instead of a fixed frequency over the load factor: that at which a result lags the excitation by a phase.
struct PhaseLag {
  std::string of;           ///< a displacement
  double lag = 0;           ///< of its harmonic at the lowest frequency of the excitation [rad]
  double from = 0, to = 0;  ///< the frequency at the lower end of the load is sought here [rad/s]
  std::string behind = {};  ///< of a result: the excitation (PeriodicExcitation::reference)
};

inline constexpr Eigen::Index most_steady_harmonics = 60;

struct SteadyOptions {
  double
      from = 0,
      to = 0;  ///< of the parameter: angular frequency of the excitation or the shaft [rad/s], or factor; 0 < from < to
  Parameter over = Parameter::frequency;
  double angular_frequency = 0;      ///< over the load factor: the fixed one [rad/s]
  std::optional<PhaseLag> at_phase;  ///< or, over the load factor, at this phase
  Eigen::Index harmonics = 9;        ///< 0: as many as `tolerance` needs, up to the next
  Eigen::Index most_harmonics = most_steady_harmonics;
  double tolerance = 1e-3;               ///< share of the deflections that the harmonics beyond may add
  std::vector<std::string> excitations;  ///< of these; empty: all harmonic ones, or without any, all orders
  std::vector<std::string> of;           ///< results, as channels; empty: none
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<assembly::MotionQuantity> quantities = {};  ///< one per result; empty: `quantity` of all
  std::vector<double> at;  ///< also exactly at these parameters, wherever the branch passes them
  bool detached = false;   ///< seek motions that are not connected with the one at the lower end of the band
  bool deep = false;       ///< judge the stability of every point in two ways
  int most_points = 20000;
};

}  // namespace trivet::nonlinear
