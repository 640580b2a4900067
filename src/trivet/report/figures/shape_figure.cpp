// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/machine_symbols.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/report/drawing/view_projection.h"
#include "trivet/response/machinery/deflection_shape.h"

namespace trivet::report {
namespace {

using foundation::two_pi;
constexpr double drawn_excursion = 0.12;  // of the size of the model

using Places = std::vector<response::MovingPlace>;

/// The drawn model, at rest or displaced, as points and lines between them.
struct Skeleton {
  std::vector<Eigen::Vector3d> poles, points, feet, heads;
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> limbs, springs;
};

std::vector<Eigen::Vector3d> positions(const Places& places, double phase, double scale) {
  std::vector<Eigen::Vector3d> result;
  for (const response::MovingPlace& place : places) result.push_back(response::displaced(place, phase, scale));
  return result;
}

Skeleton skeleton(const response::DeflectionShape& shape, double phase, double scale) {
  Skeleton s{positions(shape.bodies, phase, scale),
             positions(shape.points, phase, scale),
             positions(shape.feet, phase, scale),
             positions(shape.heads, phase, scale),
             {},
             {}};
  const auto join = [&](const Places& places, const std::vector<Eigen::Vector3d>& at) {
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i].body) s.limbs.emplace_back(s.poles[*places[i].body], at[i]);
  };
  join(shape.points, s.points);
  join(shape.feet, s.feet);
  join(shape.heads, s.heads);
  for (std::size_t e = 0; e < s.feet.size(); ++e) s.springs.emplace_back(s.feet[e], s.heads[e]);
  return s;
}

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

constexpr double least_size = 1e-3;  // of a model whose places all coincide [m]

Bounds bounds_of(const response::DeflectionShape& shape) {
  Bounds bounds;
  for (const Places* places : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
    for (const response::MovingPlace& place : *places) bounds.include(place.position);
  return bounds;
}

class Drawing {
 public:
  Drawing(SvgCanvas& canvas, const Projection& projection) : canvas_(canvas), projection_(projection) {}

  PixelPoint at(const Eigen::Vector3d& r) const { return projection_.at(r); }
  void draw(const Skeleton& s, const std::string& colour, double width) {
    for (const auto& [a, b] : s.springs)
      canvas_.line(at(a), at(b),
                   fmt::format("stroke=\"{}\" stroke-width=\"{:.1f}\" stroke-dasharray=\"3,2\"", colour, width));
    for (const auto& [a, b] : s.limbs)
      canvas_.line(at(a), at(b), fmt::format("stroke=\"{}\" stroke-width=\"{:.1f}\"", colour, width));
    for (const auto& r : s.feet) triangle(at(r), colour);
    for (const auto& r : s.heads) canvas_.circle(at(r), 2.2, fmt::format("fill=\"{}\"", colour));
    for (const auto& r : s.points)
      canvas_.circle(at(r), 3, fmt::format("fill=\"white\" stroke=\"{}\" stroke-width=\"1.3\"", colour));
    for (const auto& r : s.poles)
      canvas_.rectangle({at(r).x - 3.5, at(r).y - 3.5}, 7, 7, fmt::format("fill=\"{}\"", colour));
  }
  /// Draws the elliptical path of a place.
  void draw_path(const response::MovingPlace& place, double scale, const std::string& colour) {
    std::vector<PixelPoint> points;
    for (int i = 0; i <= 48; ++i) points.push_back(at(response::displaced(place, two_pi * i / 48, scale)));
    canvas_.polyline(points, fmt::format("stroke=\"{}\" stroke-width=\"0.8\"", colour));
  }

 private:
  void triangle(PixelPoint p, const std::string& colour) {
    canvas_.polyline({p, {p.x - 4, p.y + 7}, {p.x + 4, p.y + 7}, p},
                     fmt::format("stroke=\"{}\" stroke-width=\"1.2\"", colour));
  }
  SvgCanvas& canvas_;
  Projection projection_;
};

/// "15600" rather than "1.56e+04".
std::string three_digits(double value) {
  if (!(value >= 1000)) return fmt::format("{:.3g}", value);
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return fmt::format("{:.0f}", std::round(value / step) * step);
}

Figure shape_figure(const study::CaseResults& results, const response::DeflectionShape& shape) {
  const Bounds size = bounds_of(shape);
  const FarthestPlace most = farthest_place(shape);
  const double scale = most.excursion > 0 ? drawn_excursion * std::max(size.size(), least_size) / most.excursion : 0;
  const std::string title = case_title(fmt::format("Operating deflection shape at {:.4g} {}",
                                                   results::shown_frequency(results.display, shape.angular_frequency),
                                                   results::frequency_unit(results.display)),
                                       results);
  SvgCanvas canvas(980, 330);
  canvas.text({490, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  const Skeleton rest = skeleton(shape, 0, 0), moved = skeleton(shape, most.phase, scale);
  const auto& all = four_views();
  for (std::size_t v = 0; v < all.size(); ++v) {
    const PixelPoint corner{8 + 241.0 * static_cast<double>(v), 38};
    canvas.rectangle(corner, 235, 245, "fill=\"none\" stroke=\"#ccc\"");
    canvas.text({corner.x + 8, corner.y + 16}, all[v].name, "fill=\"#333\" font-weight=\"bold\"");
    Drawing drawing(canvas,
                    {all[v], 180 / std::max(size.size(), least_size), size.centre(), {corner.x + 117, corner.y + 125}});
    drawing.draw(rest, "#b5b5b5", 1);
    for (const Places* places : {&shape.bodies, &shape.points})
      for (const response::MovingPlace& place : *places) drawing.draw_path(place, scale, series_colour(1));
    drawing.draw(moved, series_colour(0), 1.8);
    draw_ground_axes(canvas, all[v], {corner.x + 30, corner.y + 215});
  }
  const UnitPrefix unit = unit_prefix(most.excursion, results::amplitude_unit(results.display, "m"));
  canvas.text(
      {490, 302},
      fmt::format(
          "Grey: at rest. Blue: at ωt = {:.0f}°, when {} has the largest excursion, {:.4g} {}. Orange: paths of poles "
          "and points. Motion × {}.",
          std::fmod(most.phase * 360 / two_pi + 360, 360), most.name, most.excursion * unit.factor, unit.unit,
          three_digits(scale)),
      "text-anchor=\"middle\"");
  canvas.text({490, 320},
              "Squares: poles; rings: points; dots: ends K of elements; triangles: their ends N; dashed: elements.",
              "text-anchor=\"middle\" fill=\"#444\"");
  return {title, fmt::format("shape-{}.svg", file_part(fmt::format("{:.4g}Hz", shape.angular_frequency / two_pi))),
          canvas.svg(title)};
}

}  // namespace

std::vector<Figure> shape_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  const auto& shapes = results.shapes;
  if (!shapes) return figures;
  for (const response::DeflectionShape& shape : *shapes)
    if (!shape.bodies.empty()) figures.push_back(shape_figure(results, shape));
  return figures;
}

}  // namespace trivet::report
