// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/report/drawing/plot_panel.h"
#include "trivet/study/sample/sample.h"

namespace trivet::report {

/// An axis of the picture of kept designs: a drawn number, or the margins of a requirement.
struct DesignLinesAxis {
  std::string name, detail;  ///< two lines of words
  std::string unit;          ///< empty: a pure number
  bool of_margins = false;
  Axis scale;
  bool has_infinite = false;   ///< some values are ∞, beyond the scale
  std::vector<double> values;  ///< of the kept designs in `unit`; NaN: there is none
  double given = 0;            ///< of the design of the file

  /// 0 at the left end, 1 at the right one; infinite values are there, finite ones then end before.
  [[nodiscard]] double share(double value) const;
  [[nodiscard]] double end_of_scale() const { return has_infinite ? 0.94 : 1; }
};

struct DesignLinesAxes {
  std::vector<DesignLinesAxis> numbers, margins;
  std::vector<std::string> notes;  ///< their order, and what is left out
};

/// The drawn numbers with the largest shares of the variance, or without shares with the largest correlations with a
/// margin, and the requirements that break first most often: few enough that a picture can be read.
/// @param display  units of the requirements; none: those of each case
[[nodiscard]] DesignLinesAxes design_lines_axes(const study::Sample& sample,
                                                const std::optional<project::DisplayUnits>& display);

}  // namespace trivet::report
