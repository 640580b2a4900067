// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/report/drawing/figures.h"
#include "trivet/study/sample/sample.h"

namespace trivet::report {

/// The kept designs of a sample as lines over parallel axes, below each other: the drawn numbers, then the margins.
/// Pages select ranges on the axes (web/src/report/design_lines.ts), which reads lines and axes from the picture.
/// None if no design is kept.
/// @param display  units; none: those of each case
[[nodiscard]] std::optional<Figure> design_lines_figure(
    const study::Sample& sample, const std::optional<project::DisplayUnits>& display = std::nullopt);

/// Does a page have this picture?
[[nodiscard]] bool has_design_lines(const std::string& page);

}  // namespace trivet::report
