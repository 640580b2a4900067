// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/law_loop_plot.h"
#include "trivet/report/drawing/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"

namespace trivet::report {

void draw_law_loops(SvgCanvas& canvas, PixelPoint corner, const study::ElementLaws& laws,
                    const project::ShownUnits& display) {
  constexpr double left = 90, top = 40, width = 640, height = 230;
  const bool turns = laws.turns;
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  for (const nonlinear::LawLoop& loop : laws.loops) {
    const auto [x_low, x_high] = std::ranges::minmax_element(loop.deflections);
    const auto [y_low, y_high] = std::ranges::minmax_element(loop.forces);
    low_x = std::min(low_x, *x_low);
    high_x = std::max(high_x, *x_high);
    low_y = std::min(low_y, *y_low);
    high_y = std::max(high_y, *y_high);
  }
  const UnitPrefix x_unit = unit_prefix(std::max(-low_x, high_x), results::display_unit(display, turns ? "rad" : "m")),
                   y_unit = unit_prefix(std::max(-low_y, high_y), results::display_unit(display, turns ? "N m" : "N"));
  PanelRow row;
  row.x = airy_axis(x_unit.factor * low_x, x_unit.factor * high_x, "deflection [" + x_unit.unit + "]");
  row.y = airy_axis(y_unit.factor * low_y, y_unit.factor * high_y,
                    (laws.whole ? "force [" : "force of the laws [") + y_unit.unit + "]");
  for (std::size_t i = laws.loops.size(); i-- > 0;) {
    const nonlinear::LawLoop& loop = laws.loops[i];
    const std::string stroke = fmt::format("stroke=\"{}\" stroke-width=\"1.8\"", series_colour(i));
    // Falling from the largest deflection, then rising to it: both with ascending x.
    const std::size_t half = loop.deflections.size() / 2;
    PanelCurve falling{{fmt::format("± {:.4g} {}", x_unit.factor * loop.amplitude, x_unit.unit)}, {}, {}, stroke},
        rising{{}, {}, {}, stroke};
    for (std::size_t s = 0; s < loop.deflections.size(); ++s) {
      PanelCurve& to = s < half ? falling : rising;
      to.x.push_back(x_unit.factor * loop.deflections[s]);
      to.y.push_back(y_unit.factor * loop.forces[s]);
    }
    falling.x.push_back(rising.x.front());
    falling.y.push_back(rising.y.front());
    std::ranges::reverse(falling.x);
    std::ranges::reverse(falling.y);
    row.curves.push_back(std::move(falling));
    row.curves.push_back(std::move(rising));
  }
  canvas.text({corner.x + left, corner.y + 22},
              fmt::format("Slow loops {}{}", laws.words, laws.whole ? "" : ", of the laws alone"),
              "font-weight=\"bold\"");
  draw_row(canvas, {{corner.x + left, corner.y + top}, width, height, row.x, row.y}, row);
  draw_key(canvas, {corner.x + left + width + 18, corner.y + top}, row.curves);
}

}  // namespace trivet::report
