// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <functional>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/results/analyses/steady_parts.h"
#include "trivet/results/format/motion_numbers.h"

/// Points, folds and changes of stability of curves of steady motions.
namespace trivet::results {

using nonlinear::Fold;
using nonlinear::ObservedMotion;
using nonlinear::StabilityChange;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

Kind varied_kind(const SteadyBranch& branch) {
  if (branch.over == nonlinear::Parameter::load_factor) return Kind::number;
  return branch.of_shaft ? Kind::speed : Kind::frequency;
}

ColumnOptions varied_options(const SteadyBranch& branch, int digits) {
  return {.unit = branch.over == nonlinear::Parameter::load_factor ? "times the load" : "", .digits = digits};
}

Quantity varied_quantity(const SteadyBranch& branch, double parameter, int digits) {
  return {parameter, varied_options(branch, digits).unit, varied_kind(branch), digits};
}

const char* stability_word(const SteadyPoint& point) {
  return point.uncertain ? "uncertain" : point.stable ? "yes" : "no";
}

std::vector<PointOfCurve> points_of_curves(const SteadyBranch& branch, std::vector<SteadyPoint> SteadyBranch::* list) {
  std::vector<PointOfCurve> points;
  for (std::size_t i = 0; i <= branch.further.size(); ++i) {
    const SteadyBranch& curve = i == 0 ? branch : branch.further[i - 1];
    for (const SteadyPoint& point : curve.*list) points.push_back({i, &curve, &point});
  }
  return points;
}

namespace {

/// Numbers of result c, in CSV and arrays.
void add_motion_columns(const Rows<PointOfCurve>& row, const SteadyBranch& branch, std::size_t c, Table& table) {
  const std::string &name = branch.results[c], &unit = branch.units[c];
  const auto motion = [c](const PointOfCurve& one) -> const ObservedMotion& { return one.point->results[c]; };
  const auto excited = [motion](const PointOfCurve& one) -> std::complex<double> {
    return motion(one).harmonics(one.curve->periods - 1);
  };
  const auto add = [&](const std::string& part, auto value, unsigned forms) {
    const std::string whole = name + part;
    table.columns.push_back(row(whole, Kind::number, "", value, {.unit = unit, .forms = forms}));
    if (forms & in_csv) table.csv.emplace_back(fmt::format("{} [{}]", whole, unit), whole);
  };
  add(" re", [excited](const PointOfCurve& one) { return excited(one).real(); }, in_csv);
  add(" im", [excited](const PointOfCurve& one) { return excited(one).imag(); }, in_csv);
  for (const MotionNumber& number : motion_numbers) {
    add(
        fmt::format(" {}", number.name),
        [motion, number](const PointOfCurve& one) { return number.value(motion(one)); }, in_csv | in_arrays);
    table.arrays.emplace_back(table.columns.back().name, table.columns.back().name);
  }
  add(" half of range", [motion](const PointOfCurve& one) { return motion(one).half_of_range(); }, in_arrays);
  table.columns.push_back(row(name, Kind::amplitude, "", excited, {.unit = unit, .forms = in_arrays}));
  table.columns.push_back(row.lists(name + " harmonics", "", "harmonic",
                                    std::vector<std::string>(to_size(branch.harmonics)),
                                    [motion](const PointOfCurve& one) -> const auto& { return motion(one).harmonics; },
                                    {.unit = unit, .forms = in_arrays}));
  for (const std::string& array : {name, name + " harmonics"}) table.arrays.emplace_back(array, array);
  table.columns.push_back(
      row("size of " + name, Kind::quantity, "largest |" + name + "|",
          [motion](const PointOfCurve& one) { return std::max(motion(one).largest, -motion(one).smallest); },
          {.unit = unit, .forms = for_people}));
}

Json motions_json(const PointOfCurve& one) {
  Json motions = Json::array();
  for (const ObservedMotion& motion : one.point->results) motions.push_back(json::motion(motion));
  return motions;
}

}  // namespace

Table steady_points(const SteadyBranch& branch, std::vector<PointOfCurve> points) {
  const Rows row(std::move(points));
  const auto of_point = [](auto member) {
    return [member](const PointOfCurve& one) { return std::invoke(member, *one.point); };
  };
  Table table{
      .plain_names = true,
      .rows = row.size(),
      .columns = {row("curve", Kind::number, "", &PointOfCurve::number),
                  row("periods", Kind::number, "", [](const PointOfCurve& one) { return one.curve->periods; }),
                  row("load_factor", Kind::number, "load factor", of_point(&SteadyPoint::load_factor), {.digits = 5}),
                  row("angular_frequency", branch.of_shaft ? Kind::speed : Kind::frequency, "at",
                      of_point(&SteadyPoint::angular_frequency)),
                  row("stable", Kind::words, "stable",
                      [](const PointOfCurve& one) { return stability_word(*one.point); },
                      {.forms = in_csv | for_people}),
                  row("stable", Kind::yes_no, "", of_point(&SteadyPoint::stable), {.forms = in_arrays}),
                  row("stable", Kind::yes_no, "",
                      [](const PointOfCurve& one) {
                        return one.point->uncertain ? std::nullopt : std::optional(one.point->stable);
                      },
                      {.forms = in_json}),
                  row("uncertain", Kind::yes_no, "", of_point(&SteadyPoint::uncertain)),
                  row("largest_multiplier", Kind::number, "", of_point(&SteadyPoint::largest_multiplier)),
                  row("contact", Kind::words, "", of_point(&SteadyPoint::contact)),
                  row("unstable_by_winding", Kind::number, "", of_point(&SteadyPoint::unstable_by_winding)),
                  row("results", Kind::words, "", motions_json, {.forms = in_json})},
      .json = {"angular_frequency", "load_factor", "stable", "largest_multiplier", "contact", "unstable_by_winding",
               "results"},
      .csv = {"curve",
              "periods",
              "angular_frequency [rad/s]",
              {"load factor", "load_factor"},
              "stable",
              {"largest multiplier", "largest_multiplier"}},
      .arrays = {"angular_frequency", "stable", "uncertain", "largest_multiplier"},
      .forms = for_programs};
  if (branch.over == nonlinear::Parameter::load_factor) table.arrays.emplace_back("load_factor");
  for (std::size_t i = 0; i < branch.stops.size(); ++i) {
    const std::string name = branch.stops[i] + " contact";
    table.columns.push_back(row(name, Kind::number, "", [i](const PointOfCurve& one) { return one.point->contact[i]; },
                                {.forms = in_csv | in_arrays}));
    table.csv.emplace_back(name, name);
    table.arrays.emplace_back(name, name);
  }
  for (std::size_t c = 0; c < branch.results.size(); ++c) add_motion_columns(row, branch, c, table);
  return table;
}

namespace {

Json point_json(const SteadyBranch& branch, const SteadyPoint& point) {
  Table table = steady_points(branch, {{0, &branch, &point}});
  table.key = whole_json;
  return as_json({{{std::move(table)}}}).at(0);
}

/// What happens at points of a curve.
/// @param columns  in addition to the point
template <typename Event>
Table event_table(const SteadyBranch& branch, const std::vector<Event>& events, std::vector<Column> columns) {
  const Rows row(events);
  const auto of_point = [](double SteadyPoint::* member) {
    return [member](const Event& one) { return one.point.*member; };
  };
  Table table{
      .rows = row.size(),
      .columns = {row("point", Kind::words, "", [&branch](const Event& one) { return point_json(branch, one.point); }),
                  row("angular_frequency", Kind::frequency, "", of_point(&SteadyPoint::angular_frequency)),
                  row("load_factor", Kind::number, "", of_point(&SteadyPoint::load_factor))}};
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  return table;
}

Table fold_table(const SteadyBranch& branch, const SteadyBranch& curve) {
  const Rows row(curve.folds);
  Table table = event_table(
      branch, curve.folds,
      {row("jump_of", Kind::words, "", [&curve](const Fold& fold) { return jump_of(curve, fold); }),
       row("lands", Kind::words, "",
           [&branch](const Fold& fold) { return fold.lands ? point_json(branch, *fold.lands) : Json(nullptr); })});
  table.key = "folds";
  table.axis = "fold";
  table.json = {"point", "jump_of", "lands"};
  table.arrays = {{"fold", "jump_of"}, "angular_frequency", "load_factor"};
  return table;
}

/// "curve 2": motions that begin where stability is lost.
std::string begins_there(const StabilityChange& change) {
  if (change.curve) return fmt::format("curve {}", *change.curve + 1);
  return change.sought ? "none was found" : "not computed";
}

Table change_table(const SteadyBranch& branch, const SteadyBranch& curve) {
  const Rows row(curve.changes);
  Table table = event_table(
      branch, curve.changes,
      {row("kind", Kind::words, "change of stability",
           [](const StabilityChange& change) { return nonlinear::words(change.kind); }),
       row("curve", Kind::number, "", &StabilityChange::curve),
       row(
           "at", varied_kind(curve), "at",
           [&curve](const StabilityChange& change) { return curve.parameter(change.point); }, varied_options(curve, 9)),
       row("begins", Kind::words, "motions that begin there", begins_there)});
  table.key = "stability_changes";
  table.axis = "change";
  table.json = {"point", "kind", "curve"};
  table.arrays = {{"change", "kind"}, "angular_frequency", "load_factor"};
  return table;
}

}  // namespace

Group followed_curve(const SteadyBranch& branch, const SteadyBranch& curve) {
  std::vector<PointOfCurve> list;
  for (const SteadyPoint& point : curve.points) list.push_back({0, &curve, &point});
  Table points = steady_points(branch, std::move(list));
  points.key = "points";
  points.axis = branch.over == nonlinear::Parameter::frequency ? "angular_frequency" : "load_factor";
  return {.parts = {{Single{.name = "left_out", .value = json::number(curve.left_out), .forms = in_json | in_arrays}},
                    {Single{.name = "ended", .value = curve.ended}},
                    {Single{.name = "corners", .value = curve.corners}},
                    {Single{.name = "closed", .value = curve.closed}},
                    {std::move(points)},
                    {fold_table(branch, curve)},
                    {change_table(branch, curve)}}};
}

}  // namespace trivet::results
