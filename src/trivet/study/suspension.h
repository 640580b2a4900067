// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/modal/suspension.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// The suspension of every body of a case.
struct SuspensionAnswer {
  std::vector<modal::BodySuspension> bodies;
  std::vector<double> excitations;                     ///< [rad/s]
  std::vector<modal::FrequencySeparation> separation;  ///< of the whole system
  foundation::Problems warnings;
};

/// @param torques  moments whose roll axes are asked for, body axes; x, y and z if empty
/// @param excitations  angular frequencies to hold against the natural ones [rad/s], > 0
[[nodiscard]] SuspensionAnswer suspension(const project::Case& variant,
                                          const std::vector<Eigen::Vector3d>& torques = {},
                                          const std::vector<double>& excitations = {});

}  // namespace trivet::study
