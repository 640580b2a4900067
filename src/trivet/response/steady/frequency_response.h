// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"

namespace trivet::response {

/// Complex amplitude of one result over the frequencies of its response, SI.
struct Curve {
  std::string name;
  std::string unit;
  Eigen::VectorXcd value;
};

/// Accuracy of the solutions behind the curves.
struct SolutionCheck {
  double worst_backward_error = 0;   ///< over all frequencies, in coordinates of unit mass diagonal
  double at_angular_frequency = 0;   ///< where it is worst [rad/s]
  int fallbacks = 0;                 ///< frequencies that needed the pivoted solver
  std::vector<double> undefined_at;  ///< [rad/s] where the dynamic stiffness is singular or a motion of the ground
                                     ///< unbounded; affected curves are NaN
};

struct FrequencyResponse {
  std::vector<double> angular_frequency;  ///< [rad/s]
  std::vector<Curve> curves;
  SolutionCheck check;
  int solves = 0;                  ///< frequencies at which the dynamic stiffness was solved
  double interpolation_error = 0;  ///< largest relative error found between those; 0: every value is solved
};

/// Steady amplitudes at the given ω ≥ 0 [rad/s]; at 0 the limit 0⁺, undefined if an absolute motion is given by its
/// velocity or acceleration. Results relative to such a ground are computed in coordinates that move with it
/// (assembly::by_coordinates).
[[nodiscard]] FrequencyResponse frequency_response(const assembly::Assembled& assembled,
                                                   const std::vector<assembly::Channel>& channels,
                                                   const assembly::Loading& loading,
                                                   const std::vector<double>& angular_frequency);

/// Phase [rad] in (−π, π]; a negative real value is +π whatever the sign of its zero imaginary part, and 0 has phase 0.
[[nodiscard]] double phase(const std::complex<double>& value);

/// Phase [rad], made continuous along the points by multiples of 2π.
[[nodiscard]] Eigen::VectorXd continuous_phase(const Eigen::VectorXcd& values);

}  // namespace trivet::response
