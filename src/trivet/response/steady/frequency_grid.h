// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/response/steady/curve_model.h"

namespace trivet::response {

[[nodiscard]] std::vector<double> linear_grid(const assembly::Band& band, int points);
/// Requires band.from > 0.
[[nodiscard]] std::vector<double> logarithmic_grid(const assembly::Band& band, int points);

/// A grid on which straight lines between the points follow every curve of a model. It includes every extremum and is
/// halved until amplitudes between points are right to 0.07 % and phases change by less than 20° per step. Steps are at
/// least 1e-9 of ω; at most 20,000 points in addition to the extrema. Values below a millionth of a curve's largest
/// amplitude are ignored.
[[nodiscard]] std::vector<double> drawing_grid(const CurveModel& model, const Peaks& peaks);

/// The same for the curves themselves.
[[nodiscard]] std::vector<double> automatic_grid(const assembly::Assembled& assembled,
                                                 const std::vector<assembly::Channel>& channels,
                                                 const assembly::Loading& loading, const Eigen::VectorXcd& poles,
                                                 const Peaks& peaks, const assembly::Band& band,
                                                 const foundation::Progress& progress = {});

}  // namespace trivet::response
