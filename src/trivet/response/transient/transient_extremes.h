// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/response/transient/time_grid.h"
#include "trivet/response/transient/transient.h"
#include "trivet/response/transient/transient_walk.h"

namespace trivet::response {

/// States from which a walk can be taken up again: one for every `every` points.
struct Checkpoints {
  Eigen::Index every = 1;
  std::vector<WalkState> states;
};

/// Raises the extremes found at the points and corners to those of the motion between its points: around the highest of
/// them the walk is taken again, and zeros of the derivative are searched in it: exact to about 1e-9 where the fastest
/// excited motion has four points in its period or more; a coarser grid may pass over it (and is warned).
/// @param row  of one answer
void search_between_points(TransientWalk& walk, const StateSpace& space, const LinearRows& row, const TimeGrid& grid,
                           const Checkpoints& checkpoints, const foundation::Progress& progress, TimeCurve& curve);

}  // namespace trivet::response
