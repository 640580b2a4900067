// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/nonlinear/branch/stable_motions.h"
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

const SteadyBranch& branch_of(const study::CaseResults& results) { return *results.find<SteadyBranch>("steady"); }

/// The connected curve, and the further ones.
std::vector<const SteadyBranch*> all_curves(const SteadyBranch& branch) {
  std::vector<const SteadyBranch*> curves = {&branch};
  for (const SteadyBranch& further : branch.further) curves.push_back(&further);
  return curves;
}

using Found = SteadyBranch::Found;

/// Numbers of one result along the branch.
template <typename Value>
std::vector<double> along(const SteadyBranch& branch, std::size_t result, const Value& value) {
  std::vector<double> numbers;
  for (const SteadyPoint& point : branch.points) numbers.push_back(value(point.results[result]));
  return numbers;
}

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

std::string steady_csv(const project::Case&, const study::CaseResults& results) {
  const SteadyBranch& branch = branch_of(results);
  if (!branch.requested_at.empty()) return harmonics_csv(branch);
  std::string text = "curve,periods,angular_frequency [rad/s],load factor,stable,largest multiplier";
  for (const std::string& stop : branch.stops) text += "," + csv_field(stop + " contact");
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    for (const char* part : {"re", "im"})
      text += "," + csv_field(fmt::format("{} {} [{}]", branch.results[c], part, branch.units[c]));
    for (const MotionNumber& course : motion_numbers)
      text += "," + csv_field(fmt::format("{} {} [{}]", branch.results[c], course.name, branch.units[c]));
  }
  text += "\n";
  const std::vector<const SteadyBranch*> curves = all_curves(branch);
  for (std::size_t number = 0; number < curves.size(); ++number)
    for (const SteadyPoint& point : curves[number]->points) {
      text += fmt::format("{},{},{},{},{},{}", number, curves[number]->periods, point.angular_frequency,
                          point.load_factor, stability_word(point), csv_number(point.largest_multiplier()));
      for (const double share : point.contact) append_csv_number(text, share);
      for (const ObservedMotion& motion : point.results) {
        const std::complex<double> excited = motion.harmonics(curves[number]->periods - 1);
        append_csv_number(text, excited.real());
        append_csv_number(text, excited.imag());
        for (const MotionNumber& course : motion_numbers) append_csv_number(text, course.value(motion));
      }
      text += "\n";
    }
  return text;
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
  SteadyBranch over_frequency;  // with the units of the frequency
  over_frequency.of_shaft = branch.of_shaft;
  std::vector<std::string> heads = {"load factor", "at [" + varied_unit(over_frequency, display) + "]", "stable"};
  for (const std::string& result : branch.results) heads.push_back("largest |" + result + "|");
  TextTable table(heads);
  constexpr std::size_t rows = 12;
  const std::size_t last = branch.points.size() - 1, every = std::max<std::size_t>(1, last / rows);
  const std::vector<double> kinds = largest_of_kinds(branch);
  for (std::size_t i = 0; i <= last; i += (i < last && i + every > last) ? last - i : every) {
    const SteadyPoint& point = branch.points[i];
    std::vector<std::string> row = {number_text(point.load_factor, 5),
                                    number_text(shown_varied(over_frequency, point.angular_frequency, display), 6),
                                    stability_word(point)};
    for (std::size_t c = 0; c < branch.results.size(); ++c)
      row.push_back(
          value_text(without_round_off(std::max(point.results[c].largest, -point.results[c].smallest), kinds[c]),
                     display_unit(display, branch.units[c])));
    table.add(row);
    if (i == last) break;
  }
  return fmt::format("  at each load the frequency is the one at which {} lags \"{}\" by {:.4g}°\n",
                     branch.at_phase->of, branch.at_phase->behind, 360 / foundation::two_pi * branch.at_phase->lag) +
      table.text();
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
  TextTable table({"deviation from rest", "largest stable", "smallest stable", "larger of both at [" + unit + "]",
                   "mean there", "magnitude of all"});
  if (!branch.requested_at.empty()) text = harmonics_text(branch, display) + text;
  const std::vector<double> kinds = largest_of_kinds(branch);
  const std::vector<nonlinear::StableExtremes> extremes = nonlinear::stable_extremes(branch);
  if (nonlinear::stable_points(branch).empty()) return text + "  no motion of this branch is stable\n";
  for (std::size_t c = 0; c < extremes.size(); ++c) {
    const DisplayUnit shown = display_unit(display, branch.units[c]);
    const nonlinear::ObservedMotion& top = extremes[c].at->results[c];
    const auto value_shown = [&](double value) { return value_text(without_round_off(value, kinds[c]), shown); };
    table.add({branch.results[c], value_shown(extremes[c].largest), value_shown(extremes[c].smallest),
               place_text(branch, *extremes[c].at, display, 5), value_shown(top.mean),
               value_shown(extremes[c].farthest_of_all)});
  }
  return text + table.text();
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
  const bool over_load = branch.over == nonlinear::Parameter::load_factor;
  const std::string axis = over_load ? "load_factor" : "angular_frequency";
  const std::vector<SteadyPoint>& points = branch.points;
  const auto harmonics = to_size(branch.harmonics);
  if (over_load) list.column(axis, "1", axis, points, &SteadyPoint::load_factor);
  list.field("angular_frequency", "rad/s", axis, points, &SteadyPoint::angular_frequency);
  list.column("stable", "1", axis, points, &SteadyPoint::stable);
  list.column("uncertain", "1", axis, points, &SteadyPoint::uncertain);
  list.column("largest_multiplier", "1", axis, points, &SteadyPoint::largest_multiplier);
  for (std::size_t i = 0; i < branch.stops.size(); ++i) {
    std::vector<double> shares;
    for (const SteadyPoint& point : points) shares.push_back(point.contact[i]);
    list.copy(branch.stops[i] + " contact", "1", axis, std::move(shares));
  }
  list.count("harmonic", harmonics);
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    const std::string &name = branch.results[c], &unit = branch.units[c];
    Eigen::VectorXcd first(to_index(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) first(to_index(i)) = points[i].results[c].harmonics(0);
    list.copy(name, unit, axis, std::move(first));
    list.mark_harmonic({name});
    for (const MotionNumber& course : motion_numbers)
      list.copy(name + " " + course.name, unit, axis, along(branch, c, course.value));
    list.lists(name + " harmonics", unit, {axis, "harmonic"}, harmonics, points,
               [c](const SteadyPoint& point) -> const Eigen::VectorXcd& { return point.results[c].harmonics; });
  }
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
