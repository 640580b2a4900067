// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/response/machinery/limit_line.h"
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

/// A frequency at which a curve is compared with a limit line.
struct ComparedPlace {
  double angular_frequency = 0;  ///< [rad/s]
  double margin = 0;             ///< limit / level
};

/// The least margin near a place, by Newton steps on ln|y| − ln limit: a search by values leaves eight digits of the
/// frequency, and the slopes at it would have as few. The place itself if it is an end of the band or a corner of the
/// line.
[[nodiscard]] ComparedPlace nearest_to_line(const DrivenResult& driven, const assembly::LimitLine& line,
                                            const assembly::Band& band, const ComparedPlace& place);

}  // namespace trivet::study
