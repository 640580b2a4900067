// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/report/drawing/figures.h"
#include "trivet/study/sample/sample.h"

namespace trivet::report {

/// The bands of a sample, one panel per case and result: 5 … 95 % shaded, median, extremes, the given design and limits
/// over frequency. None without bands over at least two frequencies.
/// @param display  units; none: those of each case
[[nodiscard]] std::optional<Figure> band_figure(const study::Sample& sample,
                                                const std::optional<project::DisplayUnits>& display = std::nullopt);

}  // namespace trivet::report
