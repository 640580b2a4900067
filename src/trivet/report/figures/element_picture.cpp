// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/element_picture.h"

#include <vector>

#include "trivet/report/figures/amplitude_stiffness_plot.h"
#include "trivet/report/figures/dynamic_stiffness_plot.h"
#include "trivet/report/figures/law_loop_plot.h"
#include "trivet/report/figures/residual_plot.h"
#include "trivet/report/figures/stiffness_map.h"

namespace trivet::report {

std::string element_picture(const project::Case& variant, std::size_t index) {
  constexpr double width = 980, title_height = 44, gap = 20;
  const model::Element& element = variant.system.elements()[index];
  const bool identified = element.evidence && !element.evidence->residuals.empty();
  const auto band = dynamic_band(element.law);
  const double residuals = identified ? residual_plot_height(element.evidence->residuals) + gap : 0;
  const double dynamics = band ? dynamic_stiffness_plot_height + gap : 0;
  std::vector<study::ElementLaws> laws = study::element_laws(variant, index);
  std::erase_if(laws, [](const study::ElementLaws& one) { return one.loops.empty(); });
  const double loops = static_cast<double>(laws.size()) * law_loop_plot_height;

  const std::vector<nonlinear::AmplitudeStiffness> over_amplitude = study::stiffness_over_amplitude(variant, index);
  const double amplitudes = over_amplitude.empty() ? 0 : amplitude_stiffness_plot_height;

  SvgCanvas canvas(width, title_height + stiffness_map_height + residuals + dynamics + amplitudes + loops);
  const std::string title = element.name + ", " + element.type + (variant.name.empty() ? "" : ", " + variant.name);
  canvas.text({width / 2, 24}, title, "text-anchor=\"middle\" font-size=\"15\" font-weight=\"bold\"");
  canvas.text({width / 2, 40}, "stiffness 12×12 in local axes", "text-anchor=\"middle\" fill=\"#333\"");
  draw_stiffness_map(canvas, {20, title_height}, elements::stiffness(element.law));
  double y = title_height + stiffness_map_height;
  if (identified) {
    draw_residuals(canvas, {0, y}, element.evidence->residuals);
    y += residuals;
  }
  if (band) draw_dynamic_stiffness(canvas, {0, y}, element.law, *band);
  y += dynamics;
  if (!over_amplitude.empty()) draw_amplitude_stiffness(canvas, {0, y}, over_amplitude, variant.display);
  y += amplitudes;
  for (const study::ElementLaws& one : laws) {
    draw_law_loops(canvas, {0, y}, one, variant.display);
    y += law_loop_plot_height;
  }
  return canvas.svg("Stiffness of element " + title);
}

}  // namespace trivet::report
