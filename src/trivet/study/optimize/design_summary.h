// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::study {

/// A body on its elements with all other bodies fixed.
struct BodyDecoupling {
  std::string body;
  double least = 0;  ///< over its modes: share of the kinetic energy in the coordinate with the largest share
};

/// Numbers of a design that are compared with those of another one.
struct DesignSummary {
  std::vector<double> angular_frequencies;  ///< natural ones above 0, ascending [rad/s]
  std::vector<BodyDecoupling> decoupling;   ///< of the bodies with two free coordinates or more, if it can be computed
};

[[nodiscard]] DesignSummary design_summary(const model::System& system);

}  // namespace trivet::study
