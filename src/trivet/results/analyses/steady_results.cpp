// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <functional>
#include <utility>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/results/analyses/steady_changes_text.h"
#include "trivet/results/analyses/steady_harmonics.h"
#include "trivet/results/analyses/steady_kinds.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/motion_numbers.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/results/format/written_results.h"

/// Periodic motions of nonlinear machines.
namespace trivet::results {

using nonlinear::Fold;
using nonlinear::ObservedMotion;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

namespace {

const SteadyBranch& branch_of(const study::CaseResults& results) { return *results.steady; }

/// A motion with its curve: 0 is the connected one, others are numbered as further ones.
struct PointOfCurve {
  std::size_t curve;
  const SteadyBranch* of;
  const SteadyPoint* point;
};

std::vector<PointOfCurve> points_of_curves(const SteadyBranch& branch, bool further) {
  std::vector<PointOfCurve> points;
  for (std::size_t i = 0; i < (further ? branch.further.size() + 1 : 1); ++i) {
    const SteadyBranch& curve = i == 0 ? branch : branch.further[i - 1];
    for (const SteadyPoint& point : curve.points) points.push_back({i, &curve, &point});
  }
  return points;
}

using Found = SteadyBranch::Found;

}  // namespace

namespace json {
namespace {

Json point(const SteadyPoint& p) {
  Json motions = Json::array();
  for (const ObservedMotion& m : p.results) motions.push_back(motion(m));
  return {{"angular_frequency", p.angular_frequency},
          {"load_factor", p.load_factor},
          {"stable", p.uncertain ? Json(nullptr) : Json(p.stable)},
          {"largest_multiplier", number(p.largest_multiplier())},
          {"contact", p.contact},
          {"unstable_by_winding", p.unstable_by_winding ? Json(*p.unstable_by_winding) : Json(nullptr)},
          {"results", std::move(motions)}};
}

const char* multipliers_of(const SteadyBranch& branch) {
  switch (branch.multipliers_of) {
    case SteadyBranch::Multipliers::viscous_machine:
      return "nearest viscous machine";
    case SteadyBranch::Multipliers::constant_machine:
      return "nearest machine with constant matrices";
    case SteadyBranch::Multipliers::machine:
      break;
  }
  return "machine";
}

/// Points, folds and changes of one curve.
Json followed_curve(const SteadyBranch& branch) {
  Json result{{"left_out", number(branch.left_out)},
              {"ended", branch.ended},
              {"corners", branch.corners},
              {"closed", branch.closed},
              {"points", Json::array()},
              {"folds", Json::array()},
              {"stability_changes", Json::array()}};
  for (const SteadyPoint& p : branch.points) result["points"].push_back(point(p));
  for (const Fold& fold : branch.folds)
    result["folds"].push_back({{"point", point(fold.point)},
                               {"jump_of", jump_of(branch, fold)},
                               {"lands", fold.lands ? point(*fold.lands) : Json(nullptr)}});
  for (const nonlinear::StabilityChange& change : branch.changes)
    result["stability_changes"].push_back({{"point", point(change.point)},
                                           {"kind", nonlinear::words(change.kind)},
                                           {"curve", change.curve ? Json(*change.curve) : Json(nullptr)}});
  return result;
}

Json steady(const project::Case&, const study::CaseResults& results) {
  const SteadyBranch& branch = branch_of(results);
  Json result{
      {"over", branch.over == nonlinear::Parameter::frequency ? "frequency" : "load_factor"},
      {"at_phase",
       branch.at_phase
           ? Json{{"of", branch.at_phase->of}, {"lag", branch.at_phase->lag}, {"behind", branch.at_phase->behind}}
           : Json(nullptr)},
      {"excitations", branch.excitations},
      {"of_shaft", branch.of_shaft},
      {"first_harmonic", branch.first_harmonic},
      {"harmonics", branch.harmonics},
      {"held_share", number(branch.held_share)},
      {"begun_at", branch.begun_at ? Json(*branch.begun_at) : Json(nullptr)},
      {"stops", branch.stops},
      {"multipliers_of", multipliers_of(branch)},
      {"of_amplitude", branch.of_amplitude},
      {"winding",
       {{"points", branch.winding.points},
        {"undecided", branch.winding.undecided},
        {"differs_at", branch.winding.differs_at},
        {"decides", branch.winding.decides}}},
      {"search", nullptr},
      {"further", Json::array()},
      {"results", Json::array()},
      {"warnings", warnings(results.warnings)}};
  for (std::size_t c = 0; c < branch.results.size(); ++c)
    result["results"].push_back({{"name", branch.results[c]}, {"unit", branch.units[c]}});
  result.update(followed_curve(branch));
  if (!branch.requested_at.empty()) result["at"] = harmonics(branch);
  if (branch.search)
    result["search"] = {{"places", branch.search->places},
                        {"starts", branch.search->starts},
                        {"beside_unstable", branch.search->beside_unstable},
                        {"positions_of_rest", branch.search->rests},
                        {"resonances", branch.search->resonances},
                        {"load_up_to", branch.search->load_up_to}};
  for (const SteadyBranch& curve : branch.further) {
    Json one{{"found", curve.found == Found::detached ? "detached" : "branched"},
             {"periods", curve.periods},
             {"harmonics", curve.harmonics}};
    one.update(followed_curve(curve));
    result["further"].push_back(std::move(one));
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

/// Numbers of result c, in CSV and arrays.
void add_motion_columns(const Rows<PointOfCurve>& row, const SteadyBranch& branch, std::size_t c, Table& table) {
  const std::string &name = branch.results[c], &unit = branch.units[c];
  const auto motion = [c](const PointOfCurve& one) -> const ObservedMotion& { return one.point->results[c]; };
  const auto excited = [motion](const PointOfCurve& one) -> std::complex<double> {
    return motion(one).harmonics(one.of->periods - 1);
  };
  const auto add = [&](const std::string& part, unsigned forms, auto value) {
    table.columns.push_back(row(name + part, Kind::number, "", value, {.unit = unit, .forms = forms}));
    table.csv.emplace_back(fmt::format("{}{} [{}]", name, part, unit), name + part);
  };
  add(" re", in_csv, [excited](const PointOfCurve& one) { return excited(one).real(); });
  add(" im", in_csv, [excited](const PointOfCurve& one) { return excited(one).imag(); });
  for (const MotionNumber& course : motion_numbers)
    add(fmt::format(" {}", course.name), in_csv | in_arrays,
        [motion, course](const PointOfCurve& one) { return course.value(motion(one)); });
  table.columns.push_back(row(name, Kind::amplitude, "", excited, {.unit = unit, .forms = in_arrays}));
  table.columns.push_back(row.lists(name + " harmonics", "", "harmonic",
                                    std::vector<std::string>(to_size(branch.harmonics)),
                                    [motion](const PointOfCurve& one) -> const auto& { return motion(one).harmonics; },
                                    {.unit = unit, .forms = in_arrays}));
  table.columns.push_back(
      row("size of " + name, Kind::quantity, "largest |" + name + "|",
          [motion](const PointOfCurve& one) { return std::max(motion(one).largest, -motion(one).smallest); },
          {.unit = unit, .forms = for_people}));
}

/// A line for each motion: CSV, arrays, and for people the frequency and the largest values at each load.
Table steady_points(const SteadyBranch& branch, std::vector<PointOfCurve> points, unsigned form) {
  const Rows row(std::move(points));
  const auto of_point = [](auto member) {
    return [member](const PointOfCurve& one) { return std::invoke(member, *one.point); };
  };
  const bool over_load = branch.over == nonlinear::Parameter::load_factor;
  const unsigned in_tables = in_csv | for_people;
  Table table{.axis = over_load ? "load_factor" : "angular_frequency",
              .plain_names = true,
              .file = "steady.csv",
              .rows = row.size(),
              .columns = {row("curve", Kind::number, "", &PointOfCurve::curve, {.forms = in_csv}),
                          row("periods", Kind::number, "", [](const PointOfCurve& one) { return one.of->periods; },
                              {.forms = in_csv}),
                          row("load_factor", Kind::number, "load factor", of_point(&SteadyPoint::load_factor),
                              {.digits = 5, .forms = over_load ? everywhere : in_tables}),
                          row("angular_frequency", branch.of_shaft ? Kind::speed : Kind::frequency, "at",
                              of_point(&SteadyPoint::angular_frequency)),
                          row("stable", Kind::words, "stable",
                              [](const PointOfCurve& one) { return stability_word(*one.point); }, {.forms = in_tables}),
                          row("stable", Kind::yes_no, "", of_point(&SteadyPoint::stable), {.forms = in_arrays}),
                          row("uncertain", Kind::yes_no, "", of_point(&SteadyPoint::uncertain), {.forms = in_arrays}),
                          row("largest_multiplier", Kind::number, "", of_point(&SteadyPoint::largest_multiplier))},
              .csv = {"curve",
                      "periods",
                      "angular_frequency [rad/s]",
                      {"load factor", "load_factor"},
                      "stable",
                      {"largest multiplier", "largest_multiplier"}},
              .forms = form};
  for (std::size_t i = 0; i < branch.stops.size(); ++i) {
    const std::string name = branch.stops[i] + " contact";
    table.columns.push_back(row(name, Kind::number, "", [i](const PointOfCurve& one) { return one.point->contact[i]; },
                                {.forms = for_programs}));
    table.csv.emplace_back(name, name);
  }
  for (std::size_t c = 0; c < branch.results.size(); ++c) add_motion_columns(row, branch, c, table);
  return table;
}

std::string steady_csv(const project::Case&, const study::CaseResults& results) {
  const SteadyBranch& branch = branch_of(results);
  if (!branch.requested_at.empty()) return harmonics_csv(branch);
  return as_csv({{{steady_points(branch, points_of_curves(branch, true), in_csv)}}}, "steady.csv");
}

std::string stability_text(const SteadyBranch& branch) {
  const SteadyBranch::Winding& winding = branch.winding;
  std::string text;
  if (branch.multipliers_of == SteadyBranch::Multipliers::viscous_machine)
    text += "  stability: of the nearest viscous machine, because loss factors define no motion in time\n";
  if (branch.of_amplitude)
    text +=
        "  stability: with the stiffness and loss of each motion's amplitude, and by the folds over it, because such "
        "forces are known for steady motion only; there is no second verdict\n";
  if (winding.decides)
    return text +
        fmt::format(
               "  stability: by the winding number, because the nearest machine with constant matrices differs; it "
               "cannot tell at {} of {} points, which keep the verdict of the multipliers\n",
               winding.undecided, winding.points);
  if (branch.multipliers_of == SteadyBranch::Multipliers::constant_machine)
    text += "  stability: multipliers of the nearest machine with constant matrices\n";
  if (winding.points > 0)
    text += fmt::format("  stability: the winding number agrees at {} of {} points{}\n",
                        winding.points - winding.undecided - std::ssize(winding.differs_at), winding.points,
                        winding.undecided > 0 ? fmt::format(" and cannot tell at {}", winding.undecided) : "");
  return text;
}

std::string orders_text(const SteadyBranch& branch) {
  if (!branch.of_shaft) return "";
  return fmt::format("Orders of a shaft: harmonic k of the motion is order {:.6g} k\n", branch.first_harmonic);
}

/// Where the frequency follows a phase: a few points along the curve.
std::string phase_text(const SteadyBranch& branch, const project::DisplayUnits& display) {
  if (!branch.at_phase) return "";
  Table table = steady_points(branch, points_of_curves(branch, false), for_people);
  table.people_rows = spread_rows(table.rows, 12);
  return fmt::format("  at each load the frequency is the one at which {} lags \"{}\" by {:.4g}°\n",
                     branch.at_phase->of, branch.at_phase->behind, 360 / foundation::two_pi * branch.at_phase->lag) +
      as_text({{{std::move(table)}}}, display);
}

std::string steady_text(const project::Case& variant, const study::CaseResults& results) {
  const SteadyBranch& branch = branch_of(results);
  const project::DisplayUnits& display = variant.display;
  const std::string unit = varied_unit(branch, display);
  const auto [low, high] = std::ranges::minmax_element(branch.points, [&](const SteadyPoint& a, const SteadyPoint& b) {
    return branch.parameter(a) < branch.parameter(b);
  });
  std::string text = excited_at_once(branch.excitations) + orders_text(branch) +
      fmt::format("Periodic motions from {} to {} {}, connected with {}{}\n"
                  "  {} points, {} of them unstable{}; {} {} at most {:.2g} of the deflections\n",
                  place_text(branch, *low, display, 5), place_text(branch, *high, display, 5), unit,
                  begun_words(branch, display), branch.search ? "" : " (detached ones are not sought)",
                  branch.points.size(), unstable_points(branch), uncertain_words(branch), branch.harmonics,
                  harmonics_that_leave_out(branch.harmonics), branch.left_out);
  if (!branch.ended.empty()) text += "  " + branch.ended + "\n";
  for (const double corner : branch.corners)
    text += fmt::format("  corner at {} {}: the curve turns at once, and was sought beyond at a fixed {}\n",
                        number_text(shown_varied(branch, corner, display), 6), unit, varied_word(branch));
  text += stability_text(branch) + phase_text(branch, display);
  text += detached_text(branch, display) + changes_text(branch, display) + folds_text(branch, display);
  if (!branch.requested_at.empty()) text = harmonics_text(branch, display) + text;
  return text + as_text({{{stable_table(branch)}}}, display);
}

/// Points of all further curves, one after another.
void further_arrays(const SteadyBranch& branch, LabelledArrays& list) {
  std::vector<SteadyPoint> points;
  std::vector<double> curve;
  for (std::size_t i = 0; i < branch.further.size(); ++i)
    for (const SteadyPoint& point : branch.further[i].points) {
      points.push_back(point);
      curve.push_back(static_cast<double>(i + 1));
    }
  list.count("further_curve", branch.further.size());
  list.texts("further.found", "further_curve", branch.further,
             [](const SteadyBranch& one) { return one.found == Found::detached ? "detached" : "branched"; });
  list.column("further.periods", "1", "further_curve", branch.further,
              [](const SteadyBranch& one) { return one.periods; });
  list.copy("further.curve", "1", "further_point", curve);
  list.column("further.angular_frequency", "rad/s", "further_point", points,
              [](const SteadyPoint& point) { return point.angular_frequency; });
  list.column("further.load_factor", "1", "further_point", points,
              [](const SteadyPoint& point) { return point.load_factor; });
  list.column("further.stable", "1", "further_point", points, [](const SteadyPoint& point) { return point.stable; });
  list.column("further.uncertain", "1", "further_point", points,
              [](const SteadyPoint& point) { return point.uncertain; });
  for (std::size_t c = 0; c < branch.results.size(); ++c)
    list.column("further." + branch.results[c] + " half of range", branch.units[c], "further_point", points,
                [c](const SteadyPoint& point) { return point.results[c].half_of_range(); });
}

void steady_arrays(const project::Case&, const study::CaseResults& results, LabelledArrays& list) {
  const SteadyBranch& branch = branch_of(results);
  add_arrays({{{steady_points(branch, points_of_curves(branch, false), in_arrays)}}}, list);
  list.count("harmonic", to_size(branch.harmonics));
  list.texts("fold", "fold", branch.folds, [&](const Fold& fold) { return jump_of(branch, fold); });
  list.column("fold.angular_frequency", "rad/s", "fold", branch.folds,
              [](const Fold& fold) { return fold.point.angular_frequency; });
  list.column("fold.load_factor", "1", "fold", branch.folds, [](const Fold& fold) { return fold.point.load_factor; });
  list.texts("change", "change", branch.changes,
             [](const nonlinear::StabilityChange& change) { return nonlinear::words(change.kind); });
  list.column("change.angular_frequency", "rad/s", "change", branch.changes,
              [](const nonlinear::StabilityChange& change) { return change.point.angular_frequency; });
  list.column("change.load_factor", "1", "change", branch.changes,
              [](const nonlinear::StabilityChange& change) { return change.point.load_factor; });
  list.value("left_out", "1", branch.left_out);
  further_arrays(branch, list);
}

}  // namespace

const ResultWriter steady_results = {
    .json = json::steady,
    .tables = {{"steady.csv", steady_csv}},
    .text = steady_text,
    .arrays = steady_arrays,
};

}  // namespace trivet::results
