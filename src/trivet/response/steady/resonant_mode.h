// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/steady/peaks.h"

namespace trivet::response {

/// Sets `nearest_mode` of every peak: the undamped mode with the largest curvature |d²y_k/dω²| of its part of the
/// answer, y_k = cᵀφ_k a_k with q = Σ φ_k a_k. This mode resonates, even if one that the load does not drive or the
/// answer does not contain is nearer in frequency. Empty if no mode makes half of the curvature (resonances inside an
/// element, overdamped machines); the nearest in frequency if the peak is unbounded, or would be without round-off.
void set_nearest_modes(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                       const assembly::Loading& loading, const modal::Modes& modes, Peaks& peaks);

}  // namespace trivet::response
