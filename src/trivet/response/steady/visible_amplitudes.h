// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"

namespace trivet::response {

/// |y| of each channel at one ω [rad/s], from the exact Z(ω). A value below 1e-12 of what all coordinates together
/// could cause is round-off, and set to 0.
[[nodiscard]] Eigen::VectorXd visible_amplitudes(const assembly::Assembled& assembled,
                                                 const std::vector<assembly::Channel>& channels,
                                                 const assembly::Loading& loading, double angular_frequency);

}  // namespace trivet::response
