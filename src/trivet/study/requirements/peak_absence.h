// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/verdict.h"

/// How far a curve is from having a resonance peak, once it has none.
namespace trivet::study {

/// Where a curve without a peak is nearest to having one.
///
/// With f = |y|², x = ω² and a reference x₀, a curve that falls everywhere has the measure (x + x₀) f′/f < 0: it
/// reaches 0 where a peak appears. A curve without a peak may also fall and then rise; on the rise, that is the fall
/// over 1/x, the measure is −x (x + x₀)/x₀ · f′/f.
struct AbsentPeak {
  double angular_frequency = 0;  ///< [rad/s]
  bool rising = false;           ///< on the rise
  double measure = 0;            ///< below 0: the peak is gone by that much
};

/// The local maxima of the measure over all frequencies, the largest eight. Empty for a curve that is zero.
/// @param result     a no-peak rule without peaks
/// @param reference  √x₀ [rad/s], > 0
[[nodiscard]] std::vector<AbsentPeak> absent_peaks(const CaseContext& context, const RequirementResult& result,
                                                   double reference);

/// The measure of another model at the same place.
[[nodiscard]] double absence_measure(const model::System& system, const assembly::Assembled& assembled,
                                     const RequirementResult& result, const AbsentPeak& place, double reference);

}  // namespace trivet::study
