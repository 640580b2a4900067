// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/analyses/steady_parts.h"
#include "trivet/results/format/result_writer.h"

/// Periodic motions of nonlinear machines.
namespace trivet::results {
namespace {

using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;
using Multipliers = SteadyBranch::Multipliers;

const char* multipliers_of(const SteadyBranch& branch) {
  if (branch.multipliers_of == Multipliers::viscous_machine) return "nearest viscous machine";
  return branch.multipliers_of == Multipliers::constant_machine ? "nearest machine with constant matrices" : "machine";
}

Json further_json(const SteadyBranch& branch) {
  Json list = Json::array();
  for (const SteadyBranch& curve : branch.further) {
    Json& one =
        list.emplace_back(Json{{"found", curve.found == SteadyBranch::Found::detached ? "detached" : "branched"},
                               {"periods", curve.periods},
                               {"harmonics", curve.harmonics}});
    one.update(as_json({{{followed_curve(branch, curve)}}}));
  }
  return list;
}

void add_settings(const SteadyBranch& branch, Document& document) {
  const auto& phase = branch.at_phase;
  const auto& search = branch.search;
  const SteadyBranch::Winding& winding = branch.winding;
  const Json settings{
      {"over", branch.over == nonlinear::Parameter::frequency ? "frequency" : "load_factor"},
      {"at_phase", phase ? Json{{"of", phase->of}, {"lag", phase->lag}, {"behind", phase->behind}} : Json(nullptr)},
      {"excitations", branch.excitations},
      {"of_shaft", branch.of_shaft},
      {"first_harmonic", branch.first_harmonic},
      {"harmonics", branch.harmonics},
      {"held_share", json::number(branch.held_share)},
      {"begun_at", json::optional(branch.begun_at)},
      {"stops", branch.stops},
      {"multipliers_of", multipliers_of(branch)},
      {"of_amplitude", branch.of_amplitude},
      {"winding",
       {{"points", winding.points},
        {"undecided", winding.undecided},
        {"differs_at", winding.differs_at},
        {"decides", winding.decides}}},
      {"search",
       search ? Json{{"places", search->places},
                     {"starts", search->starts},
                     {"beside_unstable", search->beside_unstable},
                     {"positions_of_rest", search->rests},
                     {"resonances", search->resonances},
                     {"load_up_to", search->load_up_to}}
              : Json(nullptr)},
      {"further", further_json(branch)}};
  for (const auto& [name, value] : settings.items()) document.add(Single{.name = name, .value = value});
  const Rows row(branch.results);
  document.add(Table{.key = "results",
                     .rows = row.size(),
                     .columns = {row("name", Kind::words, "", [](const std::string& name) { return name; }),
                                 row("unit", Kind::words, "", [&branch](std::size_t i) { return branch.units[i]; })},
                     .forms = in_json});
}

/// From where to where, connected with what, and how exactly.
void add_course(const SteadyBranch& branch, Document& document) {
  const auto [low, high] =
      std::ranges::minmax_element(branch.points, {}, [&](const SteadyPoint& point) { return branch.parameter(point); });
  Sentence course{.parts = {"Periodic motions from ", varied_quantity(branch, branch.parameter(*low), 5), " to ",
                            varied_quantity(branch, branch.parameter(*high), 5), ", connected with the one at "}};
  if (branch.begun_at) course.parts.emplace_back(varied_quantity(branch, *branch.begun_at, 5));
  else course.parts.emplace_back("the lower end of the band");
  if (!branch.search) course.parts.emplace_back(" (detached ones are not sought)");
  document.add(std::move(course));
  const std::ptrdiff_t uncertain = uncertain_points(branch);
  const std::string counts =
      fmt::format("{} points, {} of them unstable{}; {} {} at most {:.2g} of the deflections", branch.points.size(),
                  unstable_points(branch), uncertain > 0 ? fmt::format(", {} of uncertain stability", uncertain) : "",
                  branch.harmonics, branch.harmonics == 1 ? "harmonic, which leaves out" : "harmonics, which leave out",
                  branch.left_out);
  document.add(Sentence{.parts = {counts}, .place = Sentence::Place::note});
  document.add(steady_item({branch.ended}));
  for (const double corner : branch.corners)
    document.add(steady_item(
        {"Corner at ", varied_quantity(branch, corner, 6),
         fmt::format(": the curve turns at once, and was sought beyond at a fixed {}", varied_word(branch))}));
}

/// What the stability of the motions is of, and how sure.
void add_stability(const SteadyBranch& branch, Document& document) {
  const auto add = [&](const std::string& words) { document.add(steady_item({"Stability: " + words})); };
  const SteadyBranch::Winding& winding = branch.winding;
  if (branch.multipliers_of == Multipliers::viscous_machine)
    add("of the nearest viscous machine, because loss factors define no motion in time");
  if (branch.of_amplitude)
    add("with the stiffness and loss of each motion's amplitude, and by the folds over it, because such forces are "
        "known for steady motion only; there is no second verdict");
  if (winding.decides)
    add(
        fmt::format("by the winding number, because the nearest machine with constant matrices differs; it cannot "
                    "tell at {} of {} points, which keep the verdict of the multipliers",
                    winding.undecided, winding.points));
  else if (branch.multipliers_of == Multipliers::constant_machine)
    add("multipliers of the nearest machine with constant matrices");
  if (!winding.decides && winding.points > 0)
    add(fmt::format("the winding number agrees at {} of {} points{}",
                    winding.points - winding.undecided - std::ssize(winding.differs_at), winding.points,
                    winding.undecided > 0 ? fmt::format(" and cannot tell at {}", winding.undecided) : ""));
}

/// Where the frequency follows a phase: a few points along the curve.
void add_phase(const SteadyBranch& branch, Document& document) {
  if (!branch.at_phase) return;
  document.add(steady_item(
      {fmt::format("At each load the frequency is the one at which {} lags \"{}\" by {:.4g}°", branch.at_phase->of,
                   branch.at_phase->behind, 360 / foundation::two_pi * branch.at_phase->lag)}));
  std::vector<PointOfCurve> points;
  for (const SteadyPoint& point : branch.points) points.push_back({0, &branch, &point});
  Table& table = document.add(steady_points(branch, std::move(points)));
  table.people_rows = spread_rows(table.rows, 12);
  table.forms = for_people;
}

Document steady_document(const project::Case&, const study::CaseResults& results) {
  const SteadyBranch& branch = *results.steady;
  Document document;
  if (branch.requested_at.empty())
    document.add(steady_points(branch, points_of_curves(branch, &SteadyBranch::points))).file = "steady.csv";
  else add_harmonics(branch, document);
  document.add(excited_part(branch.excitations));
  if (branch.of_shaft)
    document.add(Sentence{.parts = {fmt::format("Orders of a shaft: harmonic k of the motion is order {:.6g} k",
                                                branch.first_harmonic)}});
  add_course(branch, document);
  add_stability(branch, document);
  add_phase(branch, document);
  add_settings(branch, document);
  document.add(warnings_part(results));
  add_further_curves(branch, document);
  document.add(followed_curve(branch, branch));
  add_jumps(branch, document);
  document.add(Table{.axis = "harmonic", .rows = to_size(branch.harmonics), .forms = in_arrays});
  document.add(further_points(branch));
  if (!branch.requested_at.empty()) document.add(Single{.name = "at", .value = harmonics_json(branch)});
  return document;
}

}  // namespace

const ResultWriter steady_results = {.document = steady_document, .files = {"steady.csv"}};

}  // namespace trivet::results
