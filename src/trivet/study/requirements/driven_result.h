// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/response/steady/body_dynamics.h"

namespace trivet::study {

/// One result of a model under harmonic excitations, at any ω.
class DrivenResult {
 public:
  /// @param excitations  empty: all
  DrivenResult(const model::System& system, const assembly::Assembled& assembled, const std::string& name,
               assembly::MotionQuantity quantity, const std::vector<std::string>& excitations);
  DrivenResult(const assembly::Assembled& assembled, assembly::Channel channel, assembly::Loading load);

  /// In the coordinates of the bodies.
  [[nodiscard]] response::Dynamics at(double omega) const;

 private:
  const assembly::Assembled& assembled_;
  assembly::Channel channel_;
  assembly::Loading load_;
};

/// Derivatives of ln|y| with respect to ω.
struct LogarithmicSlope {
  double value = 0;  ///< ln|y|
  double first = 0, second = 0;
};
[[nodiscard]] LogarithmicSlope logarithmic_slope(const response::Motion& motion);

}  // namespace trivet::study
