// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/response/transient/input_course.h"
#include "trivet/response/transient/time_grid.h"

namespace trivet::response {

/// Inputs of one course at the points of a grid from which whole steps can be taken: no corner is between a point and
/// the next one, κ is constant and no derivative in `held` (bit m for the mth) jumps.
/// @param w  column i: ∬u … ü at the ith point from `point` on; its columns are the largest number of steps
/// @param place  of the course at `point`
/// @return the number of steps
[[nodiscard]] Eigen::Index sample_whole_steps(const InputCourse& course, const TimeGrid& grid, Eigen::Index point,
                                              int held, InputCourse::Place place,
                                              Eigen::Ref<Eigen::Matrix<double, 5, Eigen::Dynamic>> w);

}  // namespace trivet::response
