// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/model/system.h"
#include "trivet/nonlinear/observed_motion.h"

namespace trivet::nonlinear {

struct SteadyOptions {
  double from = 0, to = 0;  ///< band of the angular frequency [rad/s], 0 < from < to
  Eigen::Index harmonics = 9;
  std::vector<std::string> excitations;  ///< of these; empty: all harmonic ones
  std::vector<std::string> of;           ///< results, as channels; empty: none
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<double> at;  ///< also exactly at these [rad/s], wherever the branch passes them
  int most_points = 20000;
  bool with_results = true;  ///< false: motions and `left_out` only, without results, stability and jumps
};

/// A periodic motion on the branch.
struct SteadyPoint {
  double angular_frequency = 0;         ///< of the excitation [rad/s]
  Eigen::MatrixXd deflections;          ///< Fourier coefficients × nonlinear deflections
  std::vector<ObservedMotion> results;  ///< in the order of SteadyBranch::results
  Eigen::VectorXcd multipliers;
  bool stable = true;

  [[nodiscard]] double largest_multiplier() const { return multipliers.cwiseAbs().maxCoeff(); }
};

/// Where ω turns. Beyond it the motion jumps to another one at the same frequency.
struct Fold {
  SteadyPoint point;
  std::size_t after = 0;             ///< index of the point of the branch before it
  bool upper = false;                ///< ω is largest there: the jump of a rising frequency
  std::optional<SteadyPoint> lands;  ///< the only stable motion of the branch at this frequency; empty if there are
                                     ///< several or none
};

struct SteadyBranch {
  std::vector<std::string> deflections;  ///< names
  std::vector<std::string> results, units;
  std::vector<SteadyPoint> points;  ///< along the branch, from `from`
  std::vector<SteadyPoint> at;      ///< at the frequencies asked for, in the order of the branch
  std::vector<Fold> folds;          ///< in the order of the branch
  Eigen::Index harmonics = 0;
  /// Amplitudes of the machine that is linear about rest, at these frequencies; empty if it does not hold all its
  /// bodies.
  std::vector<double> linear_at;
  Eigen::MatrixXd linear;  ///< frequencies × results
  double left_out = 0;     ///< largest share of the deflections beyond the harmonics, at any point
  std::string ended;       ///< why the branch ends before the end of the band; empty: it does not
};

/// The branch of periodic motions that is connected with the motion at the lower end of the band, through all folds.
/// @throws foundation::NotComputable if there is no motion at the lower end, or for what CondensedMachine and
/// PeriodicStability cannot represent
[[nodiscard]] SteadyBranch steady_branch(const model::System& system, const SteadyOptions& options,
                                         const foundation::Progress& progress = {});

}  // namespace trivet::nonlinear
