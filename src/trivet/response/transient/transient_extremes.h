// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/response/transient/time_grid.h"
#include "trivet/response/transient/time_stepper.h"
#include "trivet/response/transient/transient.h"

namespace trivet::response {

/// States from which time stepping can restart: one for every `every` points.
struct Checkpoints {
  Eigen::Index every = 1;
  std::vector<StepperState> states;
};

/// Raises the extremes at the points and corners to those of the motion between the points: steps around the highest
/// points are repeated, and zeros of the derivative are searched in them. Exact to about 1e-9 if the fastest excited
/// motion has at least four points per period; a coarser grid may miss an extreme (with a warning).
/// @param row  of one result
void search_between_points(TimeStepper& stepper, const StateSpace& space, const LinearRows& row, const TimeGrid& grid,
                           const Checkpoints& checkpoints, const foundation::Progress& progress, TimeCurve& curve);

}  // namespace trivet::response
