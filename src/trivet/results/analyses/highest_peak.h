// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/analyses/case_results.h"

namespace trivet::results {

/// "553.2 mm aggregate.x at 0.31198 Hz": the farthest stable steady motion of a nonlinear machine, or else the highest
/// resonance peak, or else the highest maximum of the response. Results of other kinds than the first one (rotations
/// beside translations, forces) are not compared with it. Empty if the case has none of these.
[[nodiscard]] std::string highest_peak(const study::CaseResults& results);

// In the same way the largest of further analyses; empty if the case does not have them.

/// "12.3 µm/s rms table.z": of random vibration.
[[nodiscard]] std::string largest_random(const study::CaseResults& results);
/// "231 m/s² 0-p device.z at 0.012 s": the farthest from rest in time, to either side.
[[nodiscard]] std::string largest_in_time(const study::CaseResults& results);
/// "98 m/s² drop at 80 Hz": the maximax, and the natural frequency that has it.
[[nodiscard]] std::string largest_of_shocks(const study::CaseResults& results);

}  // namespace trivet::results
