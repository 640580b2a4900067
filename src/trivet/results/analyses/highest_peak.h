// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/analyses/case_results.h"

namespace trivet::results {

/// "553.2 mm aggregate.x at 0.31198 Hz": the farthest stable steady motion of a nonlinear machine, or else the highest
/// resonance peak, or else the highest maximum of the response. Results of other kinds than the first one (rotations
/// beside translations, forces) are not compared with it. Empty if the case has none of these.
[[nodiscard]] std::string highest_peak(const study::CaseResults& results);

}  // namespace trivet::results
