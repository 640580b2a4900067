// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/moved_machine.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/response/machinery/deflection_shape.h"

/// Operating deflection shapes drawn on the outline of the machine, in all views.
namespace trivet::report {
namespace {

using foundation::two_pi;
using Places = std::vector<response::MovingPlace>;

/// The place with the largest excursion, and its phase ωt.
struct FarthestPlace {
  std::string name;
  double phase = 0, excursion = 0;
};

FarthestPlace farthest_place(const response::DeflectionShape& shape) {
  FarthestPlace best;
  for (const Places* places : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
    for (const response::MovingPlace& place : *places) {
      const Eigen::Vector3cd u = place.motion.head<3>();
      const double size = response::excursion(u);
      if (!(size > best.excursion)) continue;
      const std::complex<double> square = u.cwiseProduct(u).sum();
      best = {place.name, -std::arg(square) / 2, size};  // |Re(u e^{iφ})|² = ½|u|² + ½ Re(u·u e^{2iφ})
    }
  return best;
}

/// "15600" rather than "1.56e+04".
std::string three_digits(double value) {
  if (!(value >= 1000)) return fmt::format("{:.3g}", value);
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return fmt::format("{:.0f}", std::round(value / step) * step);
}

Figure shape_figure(const MovedPicture& picture, const project::Case& variant, const study::CaseResults& results,
                    const response::DeflectionShape& shape) {
  const FarthestPlace most = farthest_place(shape);
  const MachineMotion motion = motion_of(shape, variant.system, most.phase);
  const double scale =
      picture.enlargement(std::max(most.excursion, drawn_excursion(picture.machine(), motion).largest));
  const std::string title = case_title(fmt::format("Operating deflection shape at {:.4g} {}",
                                                   results::shown_frequency(results.display, shape.angular_frequency),
                                                   results::frequency_unit(results.display)),
                                       results);
  constexpr double width = 240, edge = 6, above = 22, tallest = 190;
  const double height = above + picture.height(width - 2 * edge, tallest) + edge;
  SvgCanvas canvas(980, 28 + height + 24);
  canvas.text({490, 18}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  Places paths = shape.bodies;
  paths.insert(paths.end(), shape.points.begin(), shape.points.end());
  for (std::size_t v = 0; v < four_views().size(); ++v) {
    const PixelPoint corner{4 + 244.0 * static_cast<double>(v), 28};
    canvas.rectangle(corner, width, height, "fill=\"none\" stroke=\"#ccc\"");
    picture.draw(canvas, {corner.x + edge, corner.y + above, corner.x + width - edge, corner.y + height - edge}, v,
                 motion, scale, paths);
    canvas.text({corner.x + width - edge, corner.y + 15}, four_views()[v].name, "text-anchor=\"end\" fill=\"#595959\"");
  }
  const UnitPrefix unit = unit_prefix(most.excursion, results::amplitude_unit(results.display, "m"));
  canvas.text(
      {490, 28 + height + 18},
      fmt::format(
          "Grey: at rest. Blue: at ωt = {:.0f}°, when {} has the largest excursion, {:.4g} {}. Orange: paths of poles "
          "and points. Motion × {}.",
          std::fmod(most.phase * 360 / two_pi + 360, 360), most.name, most.excursion * unit.factor, unit.unit,
          three_digits(scale)),
      "text-anchor=\"middle\"");
  return {title, fmt::format("shape-{}.svg", file_part(fmt::format("{:.4g}Hz", shape.angular_frequency / two_pi))),
          canvas.svg(title)};
}

}  // namespace

std::vector<Figure> shape_figures(const project::Case& variant, const study::CaseResults& results) {
  std::vector<Figure> figures;
  const auto& shapes = results.shapes;
  if (!shapes || variant.system.bodies().empty()) return figures;
  const MovedPicture picture(variant);
  for (const response::DeflectionShape& shape : *shapes)
    if (!shape.bodies.empty()) figures.push_back(shape_figure(picture, variant, results, shape));
  return figures;
}

}  // namespace trivet::report
