// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/branch/steady_path.h"
#include "trivet/nonlinear/machine/reference_machine.h"

namespace trivet::nonlinear {

/// Coefficients × deflections of a motion, counted over two periods: its harmonic k is their harmonic 2k.
[[nodiscard]] Eigen::MatrixXd over_two_periods(const Eigen::MatrixXd& motion);

/// Motions that begin where those of another curve lose their stability: of the same period at a branch point, of twice
/// the period at a period doubling.
struct BranchedPath {
  std::vector<std::size_t> changes_at_ends;  ///< changes of stability: where it begins and, if at another one, ends
  int periods = 1;                           ///< of the excitation, after which the motions repeat
  std::unique_ptr<SteadyPath> path;
};

struct BranchedPaths {
  std::vector<BranchedPath> paths;
  std::vector<std::size_t> sought_at;  ///< changes of stability whose motions were sought
};

/// Follows them from the changes of a path, the first few of them, to another change or the ends of the band.
/// @param twice  the machine over two periods; empty if there is no period doubling. It must outlive the paths.
[[nodiscard]] BranchedPaths branched_paths(const std::vector<StabilityChange>& changes, const SteadyPath& connected,
                                           const ReferenceMachine& machine, const ReferenceMachine* twice,
                                           const SteadyOptions& options, const foundation::Progress& progress);

}  // namespace trivet::nonlinear
