// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/response/transient/input_course.h"
#include "trivet/response/transient/state_space.h"
#include "trivet/response/transient/transient.h"

namespace trivet::response {

/// Frequency of a mode, and the largest share of the excited energy that it may have, 0 … 1: from its modal force and
/// the jumps of the input.
struct ExcitedMode {
  double angular_frequency = 0;  ///< [rad/s] > 0
  double energy_share = 0;
};

/// Energy share above which a motion is visible in a curve: 1 % of the amplitude.
inline constexpr double noticeable_share = 1e-4;

/// All modes with the largest share of energy that one input, or the initial state, can give them. If the modes are not
/// real, all frequencies of the state equation count as excited.
[[nodiscard]] std::vector<ExcitedMode> excited_modes(const StateSpace& space, const std::vector<InputCourse>& courses,
                                                     const Eigen::VectorXd& initial);

/// Uniform times of the results.
struct TimeGrid {
  double start = 0;  ///< of the computation, at or before `from` [s]
  double from = 0, step = 0;
  Eigen::Index points = 0;
  double fastest = 0;     ///< highest frequency of the noticeably excited modes and sines [rad/s]
  double resolution = 0;  ///< times closer than this are equal [s]
  [[nodiscard]] double time(Eigen::Index point) const { return from + static_cast<double>(point) * step; }
};

/// Times as requested, or chosen as in TransientOptions. Warns if the step exceeds 1/10 of the period of an excited
/// mode, and if samples of an input are too far apart for a mode that they excite.
/// @throws foundation::InvalidInput for times out of range
[[nodiscard]] TimeGrid time_grid(const TransientOptions& options, const std::vector<ExcitedMode>& modes,
                                 const std::vector<InputCourse>& courses, const std::vector<std::string>& names,
                                 foundation::Problems& warnings);

}  // namespace trivet::response
