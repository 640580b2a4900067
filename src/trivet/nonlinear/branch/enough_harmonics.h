// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>

#include "trivet/model/system.h"
#include "trivet/nonlinear/balance/steady_equations.h"
#include "trivet/nonlinear/branch/steady_path.h"
#include "trivet/nonlinear/machine/periodic_excitation.h"

/// How many harmonics a curve of steady motion has if none are given.
namespace trivet::nonlinear {

/// The number tried next, 5, 7, 9, 12 …: one that is too small is found out early.
[[nodiscard]] Eigen::Index more_harmonics(Eigen::Index harmonics);

/// @throws foundation::InvalidInput if fewer are given than the excitation has, foundation::NotComputable if it has
/// more than are computed
void check_harmonics(const SteadyOptions& options, const PeriodicExcitation& excitation);

/// Share of the deflections that those beyond may add.
[[nodiscard]] double allowed_left_out(const model::System& system, const SteadyOptions& options);

/// Number of harmonics with which that motion of a curve which leaves out most leaves out at most a share.
/// @param periods    of the excitation, after which its motions repeat: harmonics are counted over one
/// @param path_with  a path of the same machine with such a number of harmonics
[[nodiscard]] Eigen::Index harmonics_for(const SteadyPath& curve, double most_left_out, int periods,
                                         const std::function<std::unique_ptr<SteadyPath>(Eigen::Index)>& path_with);

}  // namespace trivet::nonlinear
