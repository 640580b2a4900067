// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/modal/suspension.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// Suspension properties of every body of a case.
struct SuspensionResult {
  std::vector<modal::BodySuspension> bodies;
  std::vector<double> excitations;                     ///< [rad/s]
  std::vector<modal::FrequencySeparation> separation;  ///< for the whole system
  foundation::Problems warnings;
};

/// @param torques  moments for which roll axes are computed, in body axes; x, y and z if empty
/// @param excitations  angular frequencies to compare with the natural ones [rad/s], > 0
[[nodiscard]] SuspensionResult suspension(const project::Case& variant,
                                          const std::vector<Eigen::Vector3d>& torques = {},
                                          const std::vector<double>& excitations = {});

}  // namespace trivet::study
