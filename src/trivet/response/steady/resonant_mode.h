// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/steady/peaks.h"

namespace trivet::response {

/// Sets `nearest_mode` of every peak: the undamped mode whose part of the answer, y_k = cᵀφ_k a_k with q = Σ φ_k a_k,
/// bends most with frequency there (largest |d²y_k/dω²|). That is the mode which resonates, also where one that the
/// load does not drive or the answer does not see is nearer in frequency. None where no mode makes half of the bend
/// (resonances inside an element, overdamped machines); the nearest in frequency where the peak is unbounded, or would
/// be but for round-off.
void set_nearest_modes(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                       const assembly::Loading& loading, const modal::Modes& modes, Peaks& peaks);

}  // namespace trivet::response
