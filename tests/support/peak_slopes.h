// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/channels.h"
#include "trivet/modal/modes.h"
#include "trivet/modal/roots.h"
#include "trivet/response/sensitivity/peak_shares.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::test {

inline response::Peaks peaks_of(const model::System& system, const response::SensitivityRequest& request) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  return response::peaks(assembled, assembly::channels(system, assembled, request.channels, request.quantity),
                         request.load(system, assembled), modes, modal::roots(system, assembled, modes));
}

struct PeakSlopes {
  double height = 0, frequency = 0;  ///< of their logarithms
};

/// Circles give peaks to 1e-10, so the differences need a longer step, which truncates more.
constexpr double step_by_circles = 2e-3, truncation_by_circles = 2e-5;

/// Differences of fourth order of peaks: of each place, of the peak of its curve nearest to it.
/// @param changed  the machine with a parameter changed by an amount
template <typename Changed>
std::vector<PeakSlopes> peak_slopes(const Changed& changed, double step, const response::SensitivityRequest& request,
                                    const std::vector<response::PeakPlace>& places) {
  std::vector<PeakSlopes> found(places.size());
  for (const auto& [node, weight] : {std::pair{1.0, 8.0 / 12}, {-1.0, -8.0 / 12}, {2.0, -1.0 / 12}, {-2.0, 1.0 / 12}}) {
    const response::Peaks again = peaks_of(changed(node * step), request);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const response::Peak* nearest = nullptr;
      const auto away = [&](const response::Peak& peak) {
        return std::abs(peak.angular_frequency - places[i].angular_frequency);
      };
      for (const response::Peak& peak : again.list)
        if (peak.curve == places[i].channel && (!nearest || away(peak) < away(*nearest))) nearest = &peak;
      found[i].height += weight / step * (nearest ? std::log(nearest->amplitude) : std::nan(""));
      found[i].frequency += weight / step * (nearest ? std::log(nearest->angular_frequency) : std::nan(""));
    }
  }
  return found;
}

}  // namespace trivet::test
