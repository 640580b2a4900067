// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/foundation/problems.h"
#include "trivet/response/transient/input_course.h"
#include "trivet/response/transient/state_space.h"

namespace trivet::response {

/// Results, one row each, as linear functions of the state and of the inputs.
[[nodiscard]] LinearRows answer_rows(const StateSpace& space, const std::vector<assembly::Channel>& channels,
                                     const std::vector<Drive>& courses);

/// Columns of `on_input` that are not zero.
[[nodiscard]] std::vector<Eigen::Index> used_inputs(const LinearRows& rows);

/// Warns of results that contain the derivative of a jump of an input: an impulse of zero duration, which no curve
/// shows.
void warn_of_impulses(const LinearRows& rows, const std::vector<assembly::Channel>& channels,
                      const std::vector<InputCourse>& courses, const std::vector<std::string>& names,
                      foundation::Problems& warnings);

}  // namespace trivet::response
