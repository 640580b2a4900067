// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/results/format/axis_words.h"

/// Paths of bodies and points over one period.
namespace trivet::report {
namespace {

using nonlinear::ObservedMotion;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

constexpr double figure_width = 980, first_left = 78, panel_size = 225, between_panels = 310, panel_top = 46,
                 below_orbits = 60, orbit_key_line = 20;

/// One coordinate over a period, or its rate.
std::vector<double> course(const ObservedMotion& motion, double rate_of_phase = 0) {
  constexpr int samples = 720;
  std::vector<double> values;
  for (int s = 0; s <= samples; ++s) {
    const double phase = foundation::two_pi * s / samples;
    values.push_back(rate_of_phase > 0 ? rate_of_phase * motion.slope_at(phase) : motion.value_at(phase));
  }
  return values;
}

/// A line of the figure: a motion with its words and stroke.
struct ShownMotion {
  const SteadyPoint* point = nullptr;
  double angular_frequency = 0;  ///< of its first harmonic
  std::string words, stroke;
};

/// Half of the largest range of any coordinate of a group.
double half_of_range(const SteadyPoint& point, const CurveGroup& group) {
  double largest = 0;
  for (const GroupedCurve& one : group.upper) largest = std::max(largest, point.results[one.curve].half_of_range());
  return largest;
}

/// The stable motion of the period of the excitation with the largest range of the group, and those before and after
/// the jumps of the connected curve.
std::vector<ShownMotion> shown_motions(const SteadyBranch& branch, const CurveGroup& group,
                                       const project::DisplayUnits& display) {
  constexpr std::size_t most = 7;
  std::vector<ShownMotion> shown;
  const auto show = [&](const SteadyPoint& point, const char* words) {
    if (shown.size() == most) return;
    const bool is_after = shown.size() % 2 == 0 && !shown.empty();
    shown.push_back(
        {&point, point.angular_frequency * branch.first_harmonic,
         fmt::format("{}, {:.5g} {}", words, results::shown_varied(branch, branch.parameter(point), display),
                     results::varied_unit(branch, display)),
         fmt::format("stroke=\"{}\" stroke-width=\"1.8\"{}", series_colour((shown.size() + 1) / 2),
                     is_after ? " stroke-dasharray=\"5,4\"" : "")});
  };
  const SteadyPoint* widest = nullptr;
  const auto consider = [&](const SteadyBranch& curve) {
    if (curve.periods != 1) return;
    for (const SteadyPoint& point : curve.points)
      if (point.stable && (!widest || half_of_range(point, group) > half_of_range(*widest, group))) widest = &point;
  };
  consider(branch);
  for (const SteadyBranch& curve : branch.further) consider(curve);
  if (widest) show(*widest, "largest stable motion");
  for (const nonlinear::Fold& fold : branch.folds) {
    if (!widest || !fold.lands) continue;
    show(fold.point, "before a jump");
    show(*fold.lands, "after it");
  }
  return shown;
}

/// A coordinate of all shown motions, in shown units, with the middle of its range and half of it.
struct Coordinate {
  std::string label;
  std::vector<std::vector<double>> courses;
  double middle = 0, half = 0;
};

Coordinate coordinate(std::string label, std::vector<std::vector<double>> courses, double factor) {
  double low = foundation::infinity, high = -low;
  for (std::vector<double>& one : courses)
    for (double& value : one) {
      value *= factor;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  return {std::move(label), std::move(courses), (low + high) / 2, (high - low) / 2};
}

Axis around(const Coordinate& of, double half) {
  constexpr double air = 1.1;
  if (!(half > 0)) half = 1;  // at rest
  return {of.middle - air * half, of.middle + air * half, false, of.label};
}

/// y over x of all motions in a square.
void draw_plane(SvgCanvas& canvas, double left, const Axis& x_axis, const Axis& y_axis, const Coordinate& x,
                const Coordinate& y, const std::vector<ShownMotion>& shown) {
  PanelRow row;
  row.x = x_axis;
  row.y = y_axis;
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (PanelCurve& piece : turning_curve(x.courses[i], y.courses[i], shown[i].stroke, ""))
      row.curves.push_back(std::move(piece));
  draw_row(canvas, {{left, panel_top}, panel_size, panel_size, row.x, row.y}, row);
}

/// Two or three translations: their planes, all to one scale. One alone: its rate over it.
Figure orbit_figure(const CurveGroup& group, const std::vector<ShownMotion>& shown, const study::CaseResults& results) {
  double largest = 0;
  for (const GroupedCurve& one : group.upper)
    for (const ShownMotion& motion : shown) {
      const ObservedMotion& there = motion.point->results[one.curve];
      largest = std::max({largest, there.largest, -there.smallest});
    }
  const UnitPrefix unit = unit_prefix(largest, results::display_unit(results.display, "m"));
  std::vector<Coordinate> coordinates;
  for (const GroupedCurve& one : group.upper) {
    std::vector<std::vector<double>> courses;
    for (const ShownMotion& motion : shown) courses.push_back(course(motion.point->results[one.curve]));
    coordinates.push_back(coordinate(one.label + " [" + unit.unit + "]", std::move(courses), unit.factor));
  }
  const bool alone = coordinates.size() == 1;
  if (alone) {
    const GroupedCurve& one = group.upper.front();
    std::vector<std::vector<double>> rates;
    for (const ShownMotion& motion : shown)
      rates.push_back(course(motion.point->results[one.curve], motion.angular_frequency));
    coordinates.push_back(
        coordinate("velocity of " + one.label + " [" + unit.unit + "/s]", std::move(rates), unit.factor));
  }
  double half = 0;
  for (const Coordinate& one : coordinates) half = std::max(half, one.half);
  const auto axis = [&](const Coordinate& of) { return around(of, alone ? of.half : half); };
  const bool has_one_panel = coordinates.size() == 2;  // with the key to its right, else below
  const double height =
      panel_top + panel_size + below_orbits + (has_one_panel ? 0 : orbit_key_line * static_cast<double>(shown.size()));
  SvgCanvas canvas(figure_width, height);
  const std::string title = case_title((alone ? "Motion of " : "Path of ") + group.name + " over one period", results);
  canvas.text({figure_width / 2, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  double left = first_left;
  for (const auto& [x, y] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
    if (y >= coordinates.size()) continue;
    draw_plane(canvas, left, axis(coordinates[x]), axis(coordinates[y]), coordinates[x], coordinates[y], shown);
    left += between_panels;
  }
  PixelPoint key = has_one_panel ? PixelPoint{left, panel_top + orbit_key_line}
                                 : PixelPoint{first_left, panel_top + panel_size + below_orbits};
  for (const ShownMotion& motion : shown) {
    canvas.line(key, {key.x + 28, key.y}, motion.stroke);
    canvas.text({key.x + 34, key.y + 4}, motion.words, "font-size=\"11\"");
    key.y += orbit_key_line;
  }
  return {title, "orbit-" + file_part(group.name) + ".svg", canvas.svg(title)};
}

}  // namespace

std::vector<Figure> orbit_figures(const study::CaseResults& results) {
  constexpr std::size_t most = 12;
  constexpr double round_off = 1e-9;  // of the largest motion: such a body rests
  const auto& branch = results.steady;
  std::vector<Figure> figures;
  if (!branch) return figures;
  double largest_of_all = 0;
  for (const SteadyPoint& point : branch->points)
    for (std::size_t c = 0; c < branch->results.size(); ++c)
      if (branch->units[c] == "m") largest_of_all = std::max(largest_of_all, point.results[c].half_of_range());
  std::vector<CurveName> names;
  for (std::size_t c = 0; c < branch->results.size(); ++c) names.push_back({branch->results[c], branch->units[c]});
  for (const CurveGroup& group : curve_groups(names)) {
    const auto is_motion = [&](const GroupedCurve& one) { return branch->units[one.curve] == "m"; };
    if (figures.size() == most || group.upper.empty() || !std::ranges::all_of(group.upper, is_motion)) continue;
    const std::vector<ShownMotion> shown = shown_motions(*branch, group, results.display);
    double largest = 0;
    for (const ShownMotion& motion : shown) largest = std::max(largest, half_of_range(*motion.point, group));
    if (largest > round_off * largest_of_all) figures.push_back(orbit_figure(group, shown, results));
  }
  return figures;
}

}  // namespace trivet::report
