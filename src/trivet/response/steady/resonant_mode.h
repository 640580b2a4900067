// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/steady/peaks.h"

namespace trivet::response {

/// Sets `nearest_mode` of every peak: the undamped mode whose contribution y_k = cᵀφ_k a_k to the result (q = Σ φ_k
/// a_k) has the largest curvature |d²y_k/dω²| at the peak. This is the mode that resonates, even if another, which the
/// load does not drive or the result does not contain, is closer in frequency. Empty if no mode accounts for half of
/// the curvature (resonances inside an element, overdamped machines). If the peak is unbounded, or would be but for
/// round-off: the mode nearest in frequency.
void set_nearest_modes(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                       const assembly::Loading& loading, const modal::Modes& modes, Peaks& peaks);

}  // namespace trivet::response
