// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/steady_changes_text.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/nonlinear/branch/stable_motions.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::results {

using nonlinear::Fold;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

std::string jump_of(const SteadyBranch& branch, const Fold& fold) {
  return std::string(fold.upper ? "rising " : "falling ") + varied_word(branch);
}

std::string place_text(const SteadyBranch& branch, const SteadyPoint& point, const project::DisplayUnits& display,
                       int digits) {
  return number_text(shown_varied(branch, branch.parameter(point), display), digits);
}

std::ptrdiff_t unstable_points(const SteadyBranch& curve) {
  return std::ranges::count_if(curve.points,
                               [](const SteadyPoint& point) { return !point.stable && !point.uncertain; });
}

std::string uncertain_words(const SteadyBranch& curve) {
  const auto count = std::ranges::count_if(curve.points, &SteadyPoint::uncertain);
  return count > 0 ? fmt::format(", {} of uncertain stability", count) : "";
}

const char* stability_word(const SteadyPoint& point) {
  return point.uncertain ? "uncertain" : point.stable ? "yes" : "no";
}

Table stable_table(const SteadyBranch& branch) {
  using nonlinear::StableExtremes;
  const std::vector<StableExtremes> extremes = nonlinear::stable_extremes(branch);
  const Rows row{std::vector(extremes)};
  const bool over_load = branch.over == nonlinear::Parameter::load_factor;
  return {
      .rows = row.size(),
      .columns = {row("name", Kind::words, "deviation from rest",
                      [&branch](std::size_t i) { return branch.results[i]; }),
                  row("unit", Kind::words, "", [&branch](std::size_t i) { return branch.units[i]; }),
                  row("largest", Kind::quantity, "largest stable", &StableExtremes::largest),
                  row("smallest", Kind::quantity, "smallest stable", &StableExtremes::smallest),
                  row("at",
                      over_load             ? Kind::number
                          : branch.of_shaft ? Kind::speed
                                            : Kind::frequency,
                      "larger of both at", [&branch](const StableExtremes& one) { return branch.parameter(*one.at); },
                      {.unit = over_load ? "times the load" : "", .digits = 5}),
                  row("mean", Kind::quantity, "mean there",
                      [extremes](std::size_t i) { return extremes[i].at->results[i].mean; }),
                  row("farthest", Kind::quantity, "magnitude of all, also unstable", &StableExtremes::farthest_of_all)},
      .without_rows = nonlinear::stable_points(branch).empty() ? "No motion of this branch is stable" : "",
      .forms = for_people};
}

namespace {

/// Ends of the parameter on a curve, with its folds.
std::pair<double, double> ends_of(const SteadyBranch& curve) {
  double low = foundation::infinity, high = 0;
  const auto add = [&](const SteadyPoint& point) {
    low = std::min(low, curve.parameter(point));
    high = std::max(high, curve.parameter(point));
  };
  for (const SteadyPoint& point : curve.points) add(point);
  for (const Fold& fold : curve.folds) add(fold.point);
  return {low, high};
}

/// The result that describes a jump: of those that move at all, the one that changes most, relative to its range.
std::optional<std::size_t> main_result(const SteadyBranch& branch, const Fold& fold) {
  std::optional<std::size_t> found;
  double most = -1;
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    double range = 0, of_unit = 0;
    for (const SteadyPoint& point : branch.points) {
      range = std::max(range, point.results[c].half_of_range());
      for (std::size_t i = 0; i < branch.results.size(); ++i)
        if (branch.units[i] == branch.units[c]) of_unit = std::max(of_unit, point.results[i].half_of_range());
    }
    constexpr double least = 0.1;  // of the largest of its unit
    if (!(range > least * of_unit)) continue;
    const double change = !fold.lands
        ? 0
        : std::abs(fold.lands->results[c].half_of_range() - fold.point.results[c].half_of_range()) / range;
    if (change <= most) continue;
    most = change;
    found = c;
  }
  return found;
}

/// "machine.z from 4.12 mm to 0.31 mm"
std::string jump_words(const Fold& fold, const SteadyBranch& branch, const project::DisplayUnits& display) {
  const std::optional<std::size_t> result = main_result(branch, fold);
  if (!result) return "";
  const DisplayUnit unit = display_unit(display, branch.units[*result]);
  const std::string from =
      fmt::format("{} from {}", branch.results[*result], value_text(fold.point.results[*result].half_of_range(), unit));
  return from +
      (fold.lands ? " to " + value_text(fold.lands->results[*result].half_of_range(), unit)
                  : (fold.stable_there == 0 ? "; no other stable motion is known there"
                         : fold.stable_there == 1
                         ? "; another stable motion is known there"
                         : fmt::format("; {} other stable motions are known there", fold.stable_there)));
}

}  // namespace

std::string folds_text(const SteadyBranch& branch, const project::DisplayUnits& display) {
  TextTable table({"fold", "at [" + varied_unit(branch, display) + "]", "half of the range jumps"});
  for (const Fold& fold : branch.folds)
    table.add({jump_of(branch, fold), place_text(branch, fold.point, display, 9), jump_words(fold, branch, display)});
  bool any = !branch.folds.empty();
  for (std::size_t i = 0; i < branch.further.size(); ++i)
    for (const Fold& fold : branch.further[i].folds) {
      if (!nonlinear::jumps_at(branch.further[i], fold)) continue;
      any = true;
      table.add({fmt::format("{}, curve {}", jump_of(branch, fold), i + 1), place_text(branch, fold.point, display, 9),
                 jump_words(fold, branch, display)});
    }
  const bool leaves_period = std::ranges::any_of(branch.changes, [](const nonlinear::StabilityChange& change) {
    return change.kind == nonlinear::StabilityChange::Kind::quasi_periodic;
  });
  if (any)
    return table.text() + (leaves_period ? "  quasi-periodic motions are not computed; a jump may end in one\n" : "");
  return branch.changes.empty() && branch.further.empty()
      ? "  no folds: one motion at each place of this branch, no jumps\n"
      : "  no folds: one motion at each place of this branch\n";
}

std::string detached_text(const SteadyBranch& branch, const project::DisplayUnits& display) {
  const std::vector<const SteadyBranch*> detached = branch.further_ones(SteadyBranch::Found::detached);
  if (!branch.search && detached.empty()) return "";
  std::string text = !branch.search
      ? "  another curve of motions returns to the lower end of the band\n"
      : fmt::format(
            "  detached motions: {} found; a search, not a proof: from {} random starts at {} places{}{}{}{}\n",
            detached.size(), branch.search->starts, branch.search->places,
            branch.search->beside_unstable > 0
                ? fmt::format(", from {} starts beside unstable motions", branch.search->beside_unstable)
                : "",
            branch.search->rests > 0 ? fmt::format(", from {} other positions of rest", branch.search->rests) : "",
            branch.search->load_up_to > 0
                ? fmt::format(", there with the load raised to {:g} times", branch.search->load_up_to)
                : "",
            branch.search->resonances > 0
                ? fmt::format(", and along {} {} of phase resonance", branch.search->resonances,
                              branch.search->resonances == 1 ? "curve" : "curves")
                : "");
  if (detached.empty()) return text;
  TextTable table({"detached curve", "from [" + varied_unit(branch, display) + "]", "to", "points", "unstable",
                   "largest half of the range"});
  for (std::size_t i = 0; i < detached.size(); ++i) {
    const SteadyBranch& curve = *detached[i];
    const auto [low, high] = ends_of(curve);
    std::string largest;
    double share = 0;  // of the largest on the connected curve
    for (std::size_t c = 0; c < branch.results.size(); ++c) {
      const auto top = [c](const SteadyBranch& of) {
        double value = 0;
        for (const SteadyPoint& point : of.points) value = std::max(value, point.results[c].half_of_range());
        return value;
      };
      if (!(top(branch) > 0) || !(top(curve) / top(branch) > share)) continue;
      share = top(curve) / top(branch);
      largest = branch.results[c] + " " + value_text(top(curve), display_unit(display, branch.units[c]));
    }
    table.add({fmt::format("{}{}", i + 1, curve.closed ? ", closed" : ""),
               number_text(shown_varied(branch, low, display), 7), number_text(shown_varied(branch, high, display), 7),
               std::to_string(curve.points.size()), std::to_string(unstable_points(curve)), largest});
  }
  return text + table.text();
}

namespace {

/// "twice the period, 4.03 to 4.15 Hz: 31 points, 4 of them unstable"
std::string begins_there(const SteadyBranch& branch, const nonlinear::StabilityChange& change,
                         const project::DisplayUnits& display) {
  if (!change.curve) return change.sought ? "none was found" : "not computed";
  const SteadyBranch& curve = branch.further[*change.curve];
  const auto [low, high] = ends_of(curve);
  return fmt::format("curve {}, {}, {} to {}: {} points, {} of them unstable{}{}", *change.curve + 1,
                     curve.periods == 2 ? "twice the period" : "less symmetric",
                     number_text(shown_varied(branch, low, display), 6),
                     number_text(shown_varied(branch, high, display), 6), curve.points.size(), unstable_points(curve),
                     uncertain_words(curve), curve.ended.empty() ? "" : ", not whole");
}

}  // namespace

std::string changes_text(const SteadyBranch& branch, const project::DisplayUnits& display) {
  TextTable table({"stability changes", "at [" + varied_unit(branch, display) + "]", "motions that begin there"});
  for (const nonlinear::StabilityChange& change : branch.changes)
    table.add({nonlinear::words(change.kind), place_text(branch, change.point, display, 9),
               begins_there(branch, change, display)});
  std::string text = branch.changes.empty() ? "" : table.text();
  for (const auto& [from, to] : nonlinear::without_stable_motion(branch))
    text += fmt::format(
        "  between {} and {} {} no stable motion is known; the largest values leave it out, and motions there may "
        "exceed them\n",
        number_text(shown_varied(branch, from, display), 6), number_text(shown_varied(branch, to, display), 6),
        varied_unit(branch, display));
  for (const auto& [from, to] : nonlinear::quasi_periodic_stretches(branch))
    text += fmt::format(
        "  between {} and {} {} a motion has lost its stability to quasi-periodic ones, which are not computed; the "
        "largest values leave them out, and they may exceed them\n",
        number_text(shown_varied(branch, from, display), 6), number_text(shown_varied(branch, to, display), 6),
        varied_unit(branch, display));
  return text;
}

}  // namespace trivet::results
