// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/response/machinery/deflection_shape.h"

namespace trivet::report {
namespace {

using foundation::two_pi;
constexpr double drawn_excursion = 0.12;  // of the size of the model

/// Projection of ground coordinates [m] onto the paper: right and up.
struct View {
  const char* name;
  const char* right_label;
  const char* up_label;
  Eigen::Vector3d right, up;
};

std::vector<View> views() {
  const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
  return {{"front", "x", "z", {1, 0, 0}, {0, 0, 1}},
          {"side", "y", "z", {0, 1, 0}, {0, 0, 1}},
          {"top", "x", "y", {1, 0, 0}, {0, 1, 0}},
          {"isometric", "", "", {c, -c, 0}, {-s * c, -s * c, c}}};
}

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

/// Centre and size of the model [m], the same for all views.
struct Frame {
  Eigen::Vector3d centre;
  double size;
};

Frame frame(const response::DeflectionShape& shape) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
  for (const Places* places : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
    for (const response::MovingPlace& place : *places) {
      low = low.cwiseMin(place.position);
      high = high.cwiseMax(place.position);
    }
  return {(low + high) / 2, std::max((high - low).norm(), 1e-3)};
}

class Drawing {
 public:
  Drawing(SvgCanvas& canvas, const View& view, PixelPoint middle, const Frame& frame, double pixels)
      : canvas_(canvas), view_(view), middle_(middle), frame_(frame), scale_(pixels / frame.size) {}

  PixelPoint at(const Eigen::Vector3d& r) const {
    const Eigen::Vector3d d = r - frame_.centre;
    return {middle_.x + scale_ * view_.right.dot(d), middle_.y - scale_ * view_.up.dot(d)};
  }
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
  const View& view_;
  PixelPoint middle_;
  const Frame& frame_;
  double scale_;
};

void draw_axes(SvgCanvas& canvas, const View& view, PixelPoint corner) {
  for (int axis = 0; axis < 3; ++axis) {
    const PixelPoint way{26 * view.right(axis), -26 * view.up(axis)};
    if (std::hypot(way.x, way.y) < 1) continue;
    canvas.line(corner, {corner.x + way.x, corner.y + way.y}, "stroke=\"#333\"");
    canvas.text({corner.x + 1.35 * way.x, corner.y + 1.35 * way.y + 4}, std::string(1, "xyz"[axis]),
                "text-anchor=\"middle\" fill=\"#333\"");
  }
}

/// "15600" rather than "1.56e+04".
std::string three_digits(double value) {
  if (!(value >= 1000)) return fmt::format("{:.3g}", value);
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return fmt::format("{:.0f}", std::round(value / step) * step);
}

Figure shape_figure(const study::CaseResults& results, const response::DeflectionShape& shape) {
  const Frame size = frame(shape);
  const FarthestPlace most = farthest_place(shape);
  const double scale = most.excursion > 0 ? drawn_excursion * size.size / most.excursion : 0;
  const std::string title = case_title(fmt::format("Operating deflection shape at {:.4g} {}",
                                                   results::shown_frequency(results.display, shape.angular_frequency),
                                                   results::frequency_unit(results.display)),
                                       results);
  SvgCanvas canvas(980, 740);
  canvas.text({490, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  const Skeleton rest = skeleton(shape, 0, 0), moved = skeleton(shape, most.phase, scale);
  const std::vector<View> all = views();
  for (std::size_t v = 0; v < all.size(); ++v) {
    const std::size_t row = v / 2, column = v % 2;
    const PixelPoint corner{40 + 460.0 * static_cast<double>(column), 40 + 325.0 * static_cast<double>(row)};
    canvas.rectangle(corner, 440, 315, "fill=\"none\" stroke=\"#ccc\"");
    canvas.text({corner.x + 8, corner.y + 16}, all[v].name, "fill=\"#333\" font-weight=\"bold\"");
    Drawing drawing(canvas, all[v], {corner.x + 220, corner.y + 157}, size, 270);
    drawing.draw(rest, "#b5b5b5", 1);
    for (const Places* places : {&shape.bodies, &shape.points})
      for (const response::MovingPlace& place : *places) drawing.draw_path(place, scale, series_colour(1));
    drawing.draw(moved, series_colour(0), 1.8);
    draw_axes(canvas, all[v], {corner.x + 40, corner.y + 280});
  }
  const UnitPrefix unit = unit_prefix(most.excursion, results::amplitude_unit(results.display, "m"));
  canvas.text(
      {490, 708},
      fmt::format(
          "Grey: at rest. Blue: at ωt = {:.0f}°, when {} has the largest excursion, {:.4g} {}. Orange: paths of poles "
          "and points. Motion × {}.",
          std::fmod(most.phase * 360 / two_pi + 360, 360), most.name, most.excursion * unit.factor, unit.unit,
          three_digits(scale)),
      "text-anchor=\"middle\"");
  canvas.text({490, 726},
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
