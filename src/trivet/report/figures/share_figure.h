// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/report/drawing/figures.h"
#include "trivet/study/sample/sample.h"

namespace trivet::report {

/// The shares of the variance of a sample as bars, one panel per requirement and case: those of each drawn number alone
/// and with all others, with their intervals, the largest first; one that cannot be told from 0 as its hollow interval.
/// None if no requirement has shares.
/// @param display  units; none: those of each case
[[nodiscard]] std::optional<Figure> share_figure(const study::Sample& sample,
                                                 const std::optional<project::DisplayUnits>& display = std::nullopt);

}  // namespace trivet::report
