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

/// How fast a mode is, and how much of the excited energy it may hold: from its modal force and from what jumps in the
/// input, 0 … 1.
struct ExcitedMode {
  double angular_frequency = 0;  ///< [rad/s] > 0
  double energy_share = 0;
};

/// Energy share above which a motion can be seen in a curve: an amplitude of 1 %.
inline constexpr double noticeable_share = 1e-4;

/// Every oscillation of the system with the largest share of energy that one input, or the initial state, can give it.
/// Where the modes are not real all frequencies of the state equation count as excited.
[[nodiscard]] std::vector<ExcitedMode> excited_modes(const StateSpace& space, const std::vector<InputCourse>& courses,
                                                     const Eigen::VectorXd& initial);

/// Uniform times of the answers.
struct TimeGrid {
  double start = 0;  ///< of the computation, at or before `from` [s]
  double from = 0, step = 0;
  Eigen::Index points = 0;
  double fastest = 0;     ///< of the modes and sines that are noticeably excited [rad/s]
  double resolution = 0;  ///< times closer than this are one [s]
  [[nodiscard]] double time(Eigen::Index point) const { return from + static_cast<double>(point) * step; }
};

/// Times as asked for, or chosen as TransientOptions says; warns with the numbers where the step is coarser than 1/10
/// of a period that matters, and where samples of an input are too far apart for a mode that they excite.
/// @throws foundation::InvalidInput for times out of range
[[nodiscard]] TimeGrid time_grid(const TransientOptions& options, const std::vector<ExcitedMode>& modes,
                                 const std::vector<InputCourse>& courses, const std::vector<std::string>& names,
                                 foundation::Problems& warnings);

}  // namespace trivet::response
