// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/modal/roots.h"

namespace trivet::response {

/// |y| of each channel at one ω [rad/s], from the exact Z(ω). A value below 1e-12 of what all coordinates together
/// could cause is round-off, and set to 0.
[[nodiscard]] Eigen::VectorXd visible_amplitudes(const assembly::Assembled& assembled,
                                                 const std::vector<assembly::Channel>& channels,
                                                 const assembly::Loading& loading, double angular_frequency);

/// True for each curve that vanishes at ω → 0 and ω → ∞, but not between: its highest peak is between two minima of 0,
/// whatever the damping. Tested where a curve is a power of ω: below the lowest root and above the highest. All false
/// with frequency-dependent elements or delayed loads (curves are searched up to a last ω and have no end at infinity),
/// and with a rigid-body mode (it grows towards ω = 0 and hides the others there).
[[nodiscard]] std::vector<bool> vanish_at_both_ends(const assembly::Assembled& assembled,
                                                    const std::vector<assembly::Channel>& channels,
                                                    const assembly::Loading& loading, const modal::Roots& roots);

}  // namespace trivet::response
