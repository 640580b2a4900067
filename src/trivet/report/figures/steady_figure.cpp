// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/results/format/axis_words.h"

/// Periodic motions of nonlinear machines.
namespace trivet::report {
namespace {

using nonlinear::Fold;
using nonlinear::ObservedMotion;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

constexpr std::size_t most_figures = 24;
constexpr Eigen::Index most_harmonics = 4;

double place(const SteadyBranch& branch, const SteadyPoint& point, const project::DisplayUnits& display) {
  return results::shown_varied(branch, branch.parameter(point), display);
}

/// Points of the branch in their order, folds included.
std::vector<const SteadyPoint*> course_of(const SteadyBranch& branch) {
  std::vector<const SteadyPoint*> course;
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    course.push_back(&branch.points[i]);
    for (const Fold& fold : branch.folds)
      if (fold.after == i) course.push_back(&fold.point);
  }
  return course;
}

/// What the dashed motions are.
std::string word_of_others(const SteadyBranch& branch) {
  const bool any = std::ranges::any_of(branch.points, &SteadyPoint::uncertain);
  return any ? "unstable or uncertain" : "unstable";
}

/// One result over frequency: pieces in which frequency rises or falls, stable ones solid, unstable ones dashed.
template <typename Value>
std::vector<PanelCurve> pieces(const SteadyBranch& branch, const project::DisplayUnits& display, const Value& value,
                               const std::string& colour, const std::string& name) {
  std::vector<PanelCurve> curves;
  const std::vector<const SteadyPoint*> course = course_of(branch);
  bool key_of_stable = true, key_of_unstable = true;
  const std::string others = word_of_others(branch);
  for (std::size_t i = 0; i + 1 < course.size();) {
    const bool rises = branch.parameter(*course[i + 1]) > branch.parameter(*course[i]);
    // A fold belongs to both sides: the next ordinary point says whether the piece is stable.
    const bool stable = i + 2 < course.size() || i == 0 ? course[i + 1]->stable : course[i]->stable;
    PanelCurve piece{{},
                     {},
                     {},
                     fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", colour, stable ? 2 : 1.4,
                                 stable ? "" : " stroke-dasharray=\"5,4\"")};
    const auto add = [&](const SteadyPoint& point) {
      piece.x.push_back(place(branch, point, display));
      piece.y.push_back(value(point));
    };
    add(*course[i]);
    for (++i; i < course.size(); ++i) {
      add(*course[i]);
      const bool last = i + 1 == course.size();
      if (last) break;
      const bool same_way = (branch.parameter(*course[i + 1]) > branch.parameter(*course[i])) == rises;
      if (!same_way || course[i + 1]->stable != stable) break;
    }
    bool& key = stable ? key_of_stable : key_of_unstable;
    if (key) piece.key = {name + (stable ? "" : ", " + others)};
    key = false;
    if (!rises) {
      std::ranges::reverse(piece.x);
      std::ranges::reverse(piece.y);
    }
    curves.push_back(std::move(piece));
  }
  return curves;
}

/// Dotted lines from the folds to where the motion lands.
void add_jumps(const SteadyBranch& branch, std::size_t result, const project::DisplayUnits& display,
               const UnitPrefix& unit, PanelRow& row) {
  bool key = true;
  const std::string unit_of_place =
      branch.over == nonlinear::Parameter::frequency ? " " + results::varied_unit(branch, display) : "";
  for (const Fold& fold : branch.folds) {
    const double at = place(branch, fold.point, display),
                 from = unit.factor * fold.point.results[result].half_of_range();
    row.marks.push_back({at, from, "#D55E00", fmt::format("{} {:.4g}{}", fold.upper ? "▶" : "◀", at, unit_of_place)});
    if (!fold.lands) continue;
    const double to = unit.factor * fold.lands->results[result].half_of_range();
    PanelCurve jump{{}, {at, at}, {from, to}, "stroke=\"#D55E00\" stroke-width=\"1.2\" stroke-dasharray=\"1,3\""};
    if (key) jump.key = {std::string("jumps: ▶ as the ") + results::varied_word(branch) + " rises", "◀ as it falls"};
    key = false;
    row.curves.push_back(std::move(jump));
  }
}

/// Free motions of the same result, within the band and the height of the forced ones.
std::vector<PanelCurve> nonlinear_modes(const SteadyBranch& branch, std::size_t result,
                                        const study::CaseResults& results, const UnitPrefix& unit, double highest) {
  std::vector<PanelCurve> found;
  const auto& modes = results.backbone;
  if (!modes || branch.over != nonlinear::Parameter::frequency || branch.of_shaft) return found;
  const auto [low, high] = std::ranges::minmax_element(branch.points, [](const SteadyPoint& a, const SteadyPoint& b) {
    return a.angular_frequency < b.angular_frequency;
  });
  for (const nonlinear::Backbone& mode : *modes)
    for (std::size_t c = 0; c < mode.results.size(); ++c) {
      if (mode.results[c] != branch.results[result] || mode.units[c] != branch.units[result]) continue;
      std::vector<double> x, y;
      const auto end_piece = [&] {
        for (PanelCurve& piece : turning_curve(x, y, "stroke=\"#000000\" stroke-width=\"1\"", "nonlinear mode, free")) {
          if (!found.empty()) piece.key.clear();
          found.push_back(std::move(piece));
        }
        x.clear();
        y.clear();
      };
      for (const nonlinear::BackbonePoint& point : mode.points) {
        const double height = unit.factor * point.results[c].half_of_range();
        if (point.angular_frequency < low->angular_frequency || point.angular_frequency > high->angular_frequency ||
            height > highest) {
          end_piece();
          continue;
        }
        x.push_back(results::shown_varied(branch, point.angular_frequency, results.display));
        y.push_back(height);
      }
      end_piece();
    }
  return found;
}

PanelRow range_row(const SteadyBranch& branch, std::size_t result, const study::CaseResults& results,
                   const UnitPrefix& unit) {
  const project::DisplayUnits& display = results.display;
  PanelRow row;
  if (!branch.linear_at.empty()) {
    PanelCurve linear{{"linear about rest"}, {}, {}, "stroke=\"#999999\" stroke-width=\"1\""};
    for (std::size_t i = 0; i < branch.linear_at.size(); ++i) {
      linear.x.push_back(results::shown_varied(branch, branch.linear_at[i], display));
      linear.y.push_back(unit.factor * branch.linear(to_index(i), to_index(result)));
    }
    row.curves.push_back(std::move(linear));
  }
  const auto value = [&](const SteadyPoint& point) { return unit.factor * point.results[result].half_of_range(); };
  const std::vector<PanelCurve> motion = pieces(branch, display, value, "#0072B2", "stable");
  double largest = 0;
  for (PanelCurve piece : motion) {
    if (!piece.key.empty() && piece.key.front() != "stable") piece.key.front() = word_of_others(branch);
    for (const double y : piece.y) largest = std::max(largest, y);
    row.curves.push_back(std::move(piece));
  }
  std::set<std::string> keyed;
  for (const SteadyBranch& curve : branch.further) {
    const bool is_detached = curve.found == SteadyBranch::Found::detached;
    const std::string name = is_detached ? "detached" : curve.periods == 2 ? "of twice the period" : "less symmetric";
    for (PanelCurve piece : pieces(curve, display, value, is_detached ? "#009E73" : "#CC79A7", name)) {
      const bool is_stable = !piece.key.empty() && piece.key.front() == name;
      if (!is_stable || !keyed.insert(name).second) piece.key.clear();
      for (const double y : piece.y) largest = std::max(largest, y);
      row.curves.push_back(std::move(piece));
    }
  }
  constexpr double beyond = 1.1;
  for (PanelCurve& piece : nonlinear_modes(branch, result, results, unit, beyond * largest))
    row.curves.push_back(std::move(piece));
  add_jumps(branch, result, display, unit, row);
  std::set<std::string> named;  // once each: names beside each other would overlap
  for (const nonlinear::StabilityChange& change : branch.changes) {
    const std::string name = nonlinear::words(change.kind);
    row.marks.push_back({place(branch, change.point, display),
                         unit.factor * change.point.results[result].half_of_range(), "#CC79A7",
                         named.insert(name).second ? name : ""});
  }
  row.y = airy_axis(0, largest, "half the peak-to-peak value [" + unit.unit + "]");
  return row;
}

PanelRow harmonics_row(const SteadyBranch& branch, std::size_t result, const project::DisplayUnits& display,
                       const UnitPrefix& unit) {
  PanelRow row;
  for (Eigen::Index k = 0; k <= std::min(most_harmonics, branch.harmonics); ++k) {
    const auto value = [&](const SteadyPoint& point) {
      const ObservedMotion& motion = point.results[result];
      return unit.factor * (k == 0 ? std::abs(motion.mean) : std::abs(motion.harmonics(k - 1)));
    };
    const std::string name = k == 0 ? "|mean|"
        : branch.of_shaft           ? fmt::format("order {:.4g}", static_cast<double>(k) * branch.first_harmonic)
                                    : fmt::format("harmonic {}", k);
    std::vector<PanelCurve> course = pieces(branch, display, value, series_colour(to_size(k)), name);
    const bool has_stable = std::ranges::any_of(
        course, [&](const PanelCurve& piece) { return !piece.key.empty() && piece.key.front() == name; });
    for (PanelCurve& piece : course) {
      if (!piece.key.empty() && piece.key.front() != name)  // dashes mean the same as above
        piece.key = has_stable ? std::vector<std::string>() : std::vector<std::string>{name};
      row.curves.push_back(std::move(piece));
    }
  }
  row.y = logarithmic_axis(row.curves, 1e-4, "amplitudes [" + unit.unit + "]");
  return row;
}

}  // namespace

std::vector<Figure> steady_figures(const study::CaseResults& results) {
  const auto& branch = results.steady;
  if (!branch || branch->points.size() < 3) return {};
  std::vector<double> largest;
  for (std::size_t c = 0; c < branch->results.size(); ++c) {
    double range = 0;
    for (const SteadyPoint& point : branch->points) range = std::max(range, point.results[c].half_of_range());
    for (const SteadyBranch& curve : branch->further)
      for (const SteadyPoint& point : curve.points) range = std::max(range, point.results[c].half_of_range());
    largest.push_back(range);
  }
  std::vector<Figure> figures;
  for (std::size_t c = 0; c < branch->results.size() && figures.size() < most_figures; ++c) {
    constexpr double invisible = 1e-9;  // of the largest of its unit
    double of_unit = 0;
    for (std::size_t i = 0; i < largest.size(); ++i)
      if (branch->units[i] == branch->units[c]) of_unit = std::max(of_unit, largest[i]);
    if (!(largest[c] > invisible * of_unit)) continue;
    const UnitPrefix unit = unit_prefix(largest[c], results::display_unit(results.display, branch->units[c]));
    std::vector<PanelRow> rows = {range_row(*branch, c, results, unit),
                                  harmonics_row(*branch, c, results.display, unit)};
    double from = foundation::infinity, to = 0;
    for (const PanelRow& row : rows)
      for (const PanelCurve& curve : row.curves)
        for (const double x : curve.x) {
          from = std::min(from, x);
          to = std::max(to, x);
        }
    for (PanelRow& row : rows) row.x = {from, to, false, results::varied_heading(*branch, results.display)};
    figures.push_back(panel_figure(case_title("Steady motion of " + branch->results[c], results),
                                   "steady-" + file_part(branch->results[c]) + ".svg", rows));
  }
  return figures;
}

}  // namespace trivet::report
