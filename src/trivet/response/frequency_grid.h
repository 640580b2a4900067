// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/response/peaks.h"

namespace trivet::response {

/// From, to [rad/s].
struct Band {
  double from = 0;
  double to = 0;
};

enum class Spacing { automatic, linear, logarithmic };

[[nodiscard]] std::vector<double> linear_grid(const Band& band, int points);
/// band.from > 0.
[[nodiscard]] std::vector<double> logarithmic_grid(const Band& band, int points);

/// A grid on which straight lines between the points follow every curve: dense around poles, with every extremum on it, and
/// refined until amplitudes between points are right to 0.3 % and phases turn by less than 20° per step, or until there are 6,000
/// points beside those of the poles and extrema.
[[nodiscard]] std::vector<double> automatic_grid(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                                 const assembly::Loading& loading, const Eigen::VectorXcd& poles, const Peaks& peaks,
                                                 const Band& band, const foundation::Progress& progress = {});

}  // namespace trivet::response
