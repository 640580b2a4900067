// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "trivet/nonlinear/branch/steady_branch.h"

namespace trivet::nonlinear {

/// Stable motions of a curve and of its further ones, and folds beside a stable point, which are their ends.
[[nodiscard]] std::vector<const SteadyPoint*> stable_points(const SteadyBranch& branch);

/// Does a stable motion of the curve end at its fold?
[[nodiscard]] bool jumps_at(const SteadyBranch& curve, const Fold& fold);

/// Extremes of one result over the stable motions, and over all.
struct StableExtremes {
  const SteadyPoint* at = nullptr;  ///< the stable motion that goes farthest from rest, to either side
  double largest = 0, smallest = 0;
  double farthest_of_all = 0;  ///< largest magnitude over all motions
};
/// One per result; empty without stable motions. The branch must outlive them.
[[nodiscard]] std::vector<StableExtremes> stable_extremes(const SteadyBranch& branch);

/// Stretches of the parameter, between the ends of the branch, in which no motion of a known curve is stable.
[[nodiscard]] std::vector<std::pair<double, double>> without_stable_motion(const SteadyBranch& branch);

/// Stretches beside them in which a motion of a known curve has lost its stability to quasi-periodic ones, ascending: a
/// machine that is led there may stay in these, which are not computed.
[[nodiscard]] std::vector<std::pair<double, double>> quasi_periodic_stretches(const SteadyBranch& branch);

}  // namespace trivet::nonlinear
