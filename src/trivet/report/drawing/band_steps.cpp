// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/band_steps.h"

#include <limits>
#include <utility>

namespace trivet::report {

void set_steps(PanelCurve& curve, const std::vector<excitation::FrequencyBand>& bands,
               const std::vector<double>& heights, const project::DisplayUnits& display) {
  std::vector<double> x, y;
  const auto add = [&](double omega, double height) {
    x.push_back(results::shown_frequency(display, omega));
    y.push_back(height);
  };
  for (std::size_t b = 0; b < bands.size(); ++b) {
    if (b > 0 && bands[b].index != bands[b - 1].index + 1)
      add(bands[b].from(), std::numeric_limits<double>::quiet_NaN());
    add(bands[b].from(), heights[b]);
    add(bands[b].to(), heights[b]);
  }
  curve.x = std::move(x);
  curve.y = std::move(y);
}

}  // namespace trivet::report
