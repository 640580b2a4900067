// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/amplitude_stiffness_plot.h"
#include "trivet/report/drawing/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"

namespace trivet::report {

using nonlinear::AmplitudeStiffness;

void draw_amplitude_stiffness(SvgCanvas& canvas, PixelPoint corner, const std::vector<AmplitudeStiffness>& curves,
                              const project::ShownUnits& display) {
  constexpr double left = 90, top = 40, width = 640, height = 210, between = 60;
  double largest = 0, from = foundation::infinity, to = 0;
  for (const AmplitudeStiffness& one : curves) {
    if (one.angular_frequency.empty()) continue;
    largest = std::max(largest, one.stiffness.cwiseAbs().maxCoeff());
    const auto [low, high] = std::ranges::minmax_element(one.angular_frequency);
    from = std::min(from, *low / foundation::two_pi);
    to = std::max(to, *high / foundation::two_pi);
  }
  const UnitPrefix unit = unit_prefix(largest, results::display_unit(display, "N/m")),
                   length = unit_prefix(curves.back().amplitude, results::display_unit(display, "m"));
  PanelRow magnitude, angle;
  double lowest_angle = 0, highest_angle = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const AmplitudeStiffness& one = curves[i];
    const std::string stroke = fmt::format("stroke=\"{}\" stroke-width=\"1.8\"", series_colour(i));
    PanelCurve size{{fmt::format("± {:.4g} {}", length.factor * one.amplitude, length.unit)}, {}, {}, stroke},
        phase{{}, {}, {}, stroke};
    for (std::size_t p = 0; p < one.angular_frequency.size(); ++p) {
      const std::complex<double> value = one.stiffness(to_index(p));
      const double degrees = std::arg(value) * 360 / foundation::two_pi;
      size.x.push_back(one.angular_frequency[p] / foundation::two_pi);
      size.y.push_back(unit.factor * std::abs(value));
      phase.x.push_back(size.x.back());
      phase.y.push_back(degrees);
      lowest_angle = std::min(lowest_angle, degrees);
      highest_angle = std::max(highest_angle, degrees);
    }
    magnitude.curves.push_back(std::move(size));
    angle.curves.push_back(std::move(phase));
  }
  magnitude.x = angle.x = {from, to, true, "f [Hz]"};
  magnitude.y = airy_axis(0, unit.factor * largest, "|K| [" + unit.unit + "]");
  angle.y = airy_axis(lowest_angle, highest_angle, "loss angle [°]");
  canvas.text({corner.x + left, corner.y + 22},
              "Dynamic stiffness along z of end K, N held, by the amplitude of the deflection", "font-weight=\"bold\"");
  draw_row(canvas, {{corner.x + left, corner.y + top}, width, height, magnitude.x, magnitude.y}, magnitude);
  draw_row(canvas, {{corner.x + left, corner.y + top + height + between}, width, height, angle.x, angle.y}, angle);
  draw_key(canvas, {corner.x + left + width + 18, corner.y + top}, magnitude.curves);
}

}  // namespace trivet::report
