// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/machinery/limit_line.h"
#include "trivet/study/requirements/driven_result.h"

namespace trivet::study {

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
