// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/recurrence/rows_over_time.h"
#include "trivet/response/transient/time_grid.h"
#include "trivet/response/transient/time_stepper.h"
#include "trivet/response/transient/transient.h"

namespace trivet::response {

/// Motion in blocks of `every` points: where each block starts, and bounds of each curve in it.
struct TimeBlocks {
  Eigen::Index every = 1;
  Eigen::MatrixXd states;                                 ///< one column per block: the state at its first point
  std::vector<std::vector<numerics::RowBlock>> of_curve;  ///< per curve and block
};

/// Raises the extremes at the points and corners to those of the motion between the points: steps around the highest
/// points are repeated, and zeros of the derivative are searched in them. Exact to about 1e-9 if the fastest excited
/// motion has at least four points per period; a coarser grid may miss an extreme (with a warning).
/// @param row    output row of the result
/// @param index  of the result
void search_between_points(TimeStepper& stepper, const StateSpace& space, const LinearRows& row, std::size_t index,
                           const TimeGrid& grid, const TimeBlocks& blocks, const foundation::Progress& progress,
                           TimeCurve& curve);

}  // namespace trivet::response
