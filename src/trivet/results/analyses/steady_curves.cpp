// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/nonlinear/branch/stable_motions.h"
#include "trivet/results/analyses/steady_parts.h"

/// Curves beside the connected one, and where motions jump.
namespace trivet::results {

using nonlinear::Fold;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

std::string jump_of(const SteadyBranch& curve, const Fold& fold) {
  return std::string(fold.upper ? "rising " : "falling ") + varied_word(curve);
}

std::ptrdiff_t unstable_points(const SteadyBranch& curve) {
  return std::ranges::count_if(curve.points,
                               [](const SteadyPoint& point) { return !point.stable && !point.uncertain; });
}

std::ptrdiff_t uncertain_points(const SteadyBranch& curve) {
  return std::ranges::count_if(curve.points, &SteadyPoint::uncertain);
}

namespace {

/// Least and largest parameter on a curve, with its folds.
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

/// Largest half of the peak-to-peak value of each result on a curve.
std::vector<double> halves_of_ranges(const SteadyBranch& curve) {
  std::vector<double> largest(curve.points.front().results.size());
  for (const SteadyPoint& point : curve.points)
    for (std::size_t c = 0; c < largest.size(); ++c)
      largest[c] = std::max(largest[c], point.results[c].half_of_range());
  return largest;
}

/// The result whose range is the largest, over its range on the connected curve.
std::size_t result_of(const SteadyBranch& curve, const SteadyBranch& branch) {
  const std::vector<double> own = halves_of_ranges(curve), connected = halves_of_ranges(branch);
  std::size_t found = 0;
  double share = 0;
  for (std::size_t c = 0; c < own.size(); ++c) {
    if (!(connected[c] > 0) || !(own[c] / connected[c] > share)) continue;
    share = own[c] / connected[c];
    found = c;
  }
  return found;
}

std::string found_words(const SteadyBranch& curve) {
  const bool detached = curve.found == SteadyBranch::Found::detached;
  const char* kind = detached ? "detached" : curve.periods == 2 ? "of twice the period" : "less symmetric";
  return std::string(kind) + (curve.closed ? ", closed" : "") + (curve.ended.empty() ? "" : ", not whole");
}

Table curve_table(const SteadyBranch& branch) {
  const Rows row(branch.further);
  const auto main = [&branch](const SteadyBranch& curve) { return result_of(curve, branch); };
  const auto found = [](const SteadyBranch& curve) {
    return curve.found == SteadyBranch::Found::detached ? "detached" : "branched";
  };
  const bool any_uncertain = std::ranges::any_of(branch.further, uncertain_points);
  return {
      .axis = "further_curve",
      .plain_names = true,
      .title = "Further curves",
      .rows = row.size(),
      .columns = {row("found", Kind::words, "", found), row("periods", Kind::number, "", &SteadyBranch::periods),
                  row("curve", Kind::number, "curve", [](std::size_t i) { return i + 1; }),
                  row("motions", Kind::words, "motions", found_words),
                  row(
                      "from", varied_kind(branch), "from",
                      [](const SteadyBranch& curve) { return ends_of(curve).first; }, varied_options(branch, 7)),
                  row(
                      "to", varied_kind(branch), "to", [](const SteadyBranch& curve) { return ends_of(curve).second; },
                      varied_options(branch, 7)),
                  row("points", Kind::number, "points", [](const SteadyBranch& curve) { return curve.points.size(); }),
                  row("unstable", Kind::number, "unstable", unstable_points),
                  row("uncertain", Kind::number, any_uncertain ? "uncertain" : "", uncertain_points),
                  row("result", Kind::words, "half the peak-to-peak value of",
                      [&branch, main](const SteadyBranch& curve) { return branch.results[main(curve)]; }),
                  row("unit", Kind::words, "",
                      [&branch, main](const SteadyBranch& curve) { return branch.units[main(curve)]; }),
                  row("largest", Kind::quantity, "is at most",
                      [main](const SteadyBranch& curve) { return halves_of_ranges(curve)[main(curve)]; },
                      {.digits = 4})},
      .arrays = {{"further.found", "found"}, {"further.periods", "periods"}}};
}

/// How detached motions were sought.
std::string search_words(const SteadyBranch& branch) {
  const std::size_t detached = branch.further_ones(SteadyBranch::Found::detached).size();
  if (!branch.search) return detached > 0 ? "Another curve of motions returns to the lower end of the band" : "";
  const nonlinear::DetachedSearch& search = *branch.search;
  std::string words =
      fmt::format("Detached motions: {} found; a search, not a proof: from {} random starts at {} places", detached,
                  search.starts, search.places);
  if (search.beside_unstable > 0)
    words += fmt::format(", from {} starts beside unstable motions", search.beside_unstable);
  if (search.rests > 0) words += fmt::format(", from {} other positions of rest", search.rests);
  if (search.load_up_to > 0) words += fmt::format(", there with the load raised to {:g} times", search.load_up_to);
  if (search.resonances > 0)
    words += fmt::format(", and along {} {} of phase resonance", search.resonances,
                         search.resonances == 1 ? "curve" : "curves");
  return words;
}

}  // namespace

void add_further_curves(const SteadyBranch& branch, Document& document) {
  document.add(steady_item({search_words(branch)}));
  document.add(curve_table(branch));
}

Table further_points(const SteadyBranch& branch) {
  std::vector<PointOfCurve> points = points_of_curves(branch, &SteadyBranch::points);
  std::erase_if(points, [](const PointOfCurve& one) { return one.number == 0; });
  Table table = steady_points(branch, std::move(points));
  table.axis = "further_point";
  table.counted = false;
  table.arrays.clear();
  for (const std::string name : {"curve", "angular_frequency", "load_factor", "stable", "uncertain"})
    table.arrays.emplace_back("further." + name, name);
  for (const std::string& result : branch.results)
    table.arrays.emplace_back("further." + result + " half of range", result + " half of range");
  return table;
}

namespace {

/// A fold of a curve, numbered as further ones, at which stable motions end, and a result that jumps there.
struct Jump {
  std::size_t curve;
  const Fold* fold;
  std::size_t result;

  [[nodiscard]] double before() const { return fold->point.results[result].half_of_range(); }
  [[nodiscard]] double after() const { return fold->lands ? fold->lands->results[result].half_of_range() : 0; }
};

/// With the result that describes it: of those that move at all, the one that changes most, relative to its range.
Jump jump_at(const SteadyBranch& branch, std::size_t curve, const Fold& fold) {
  const std::vector<double> ranges = halves_of_ranges(branch);
  Jump found{curve, &fold, 0};
  double most = -1;
  for (std::size_t c = 0; c < ranges.size(); ++c) {
    double of_unit = 0;
    for (std::size_t i = 0; i < ranges.size(); ++i)
      if (branch.units[i] == branch.units[c]) of_unit = std::max(of_unit, ranges[i]);
    constexpr double least = 0.1;  // of the largest of its unit
    if (!(ranges[c] > least * of_unit)) continue;
    const Jump jump{curve, &fold, c};
    const double change = fold.lands ? std::abs(jump.after() - jump.before()) / ranges[c] : 0;
    if (change <= most) continue;
    most = change;
    found = jump;
  }
  return found;
}

std::vector<Jump> jumps_of(const SteadyBranch& branch) {
  std::vector<Jump> jumps;
  for (const Fold& fold : branch.folds) jumps.push_back(jump_at(branch, 0, fold));
  for (std::size_t i = 0; i < branch.further.size(); ++i)
    for (const Fold& fold : branch.further[i].folds)
      if (nonlinear::jumps_at(branch.further[i], fold)) jumps.push_back(jump_at(branch, i + 1, fold));
  return jumps;
}

/// The same jumps with each result that moves.
std::vector<Jump> with_all_results(const SteadyBranch& branch, const std::vector<Jump>& jumps) {
  std::vector<Jump> all;
  for (const Jump& jump : jumps) {
    LargestOfKind largest;
    const auto size = [&](std::size_t c) {
      const Jump one{jump.curve, jump.fold, c};
      return std::max(one.before(), one.after());
    };
    for (std::size_t c = 0; c < branch.results.size(); ++c) largest.add(branch.units[c], size(c));
    for (std::size_t c = 0; c < branch.results.size(); ++c)
      if (largest.shown(branch.units[c], size(c)) > 0) all.push_back({jump.curve, jump.fold, c});
  }
  return all;
}

/// Half of the range beyond the jump, or what is known of where it leads.
Json landing(const Jump& jump) {
  if (jump.fold->lands) return jump.after();
  const std::size_t others = jump.fold->stable_there;
  if (others == 0) return "no other stable motion is known";
  return others == 1 ? "another stable motion is known" : fmt::format("{} other stable motions are known", others);
}

Table jump_table(const SteadyBranch& branch, std::vector<Jump> jumps) {
  const Rows row(std::move(jumps));
  return {.rows = row.size(),
          .columns = {row("jump", Kind::words, "jump of a",
                          [&branch](const Jump& jump) {
                            return jump_of(branch, *jump.fold) +
                                (jump.curve > 0 ? fmt::format(", curve {}", jump.curve) : "");
                          }),
                      row(
                          "at", varied_kind(branch), "at",
                          [&branch](const Jump& jump) { return branch.parameter(jump.fold->point); },
                          varied_options(branch, 9)),
                      row("result", Kind::words, "half the peak-to-peak value of",
                          [&branch](const Jump& jump) { return branch.results[jump.result]; }),
                      row("unit", Kind::words, "", [&branch](const Jump& jump) { return branch.units[jump.result]; }),
                      row("before", Kind::quantity, "before", &Jump::before, {.digits = 4}),
                      row("after", Kind::quantity, "after", landing, {.digits = 4})},
          .without_rows = std::string("No folds: one motion at each place of this branch") +
              (branch.changes.empty() && branch.further.empty() ? ", no jumps" : ""),
          .forms = for_people};
}

/// Largest values of the stable motions, a row for each result.
Table stable_table(const SteadyBranch& branch) {
  using nonlinear::StableExtremes;
  const Rows row(nonlinear::stable_extremes(branch));
  return {
      .rows = row.size(),
      .columns = {row("name", Kind::words, "deviation from rest",
                      [&branch](std::size_t i) { return branch.results[i]; }),
                  row("unit", Kind::words, "", [&branch](std::size_t i) { return branch.units[i]; }),
                  row("largest", Kind::quantity, "largest stable", &StableExtremes::largest),
                  row("smallest", Kind::quantity, "smallest stable", &StableExtremes::smallest),
                  row(
                      "at", varied_kind(branch), "larger of both at",
                      [&branch](const StableExtremes& one) { return branch.parameter(*one.at); },
                      varied_options(branch, 5)),
                  row("mean", Kind::quantity, "mean there",
                      [extremes = nonlinear::stable_extremes(branch)](std::size_t i) {
                        return without_round_off(extremes[i].at->results[i].mean, extremes[i].farthest_of_all);
                      }),
                  row("farthest", Kind::quantity, "magnitude of all, also unstable", &StableExtremes::farthest_of_all)},
      .without_rows = nonlinear::stable_points(branch).empty() ? "No motion of this branch is stable" : "",
      .forms = for_people};
}

}  // namespace

void add_jumps(const SteadyBranch& branch, Document& document) {
  const auto add_stretch = [&](const std::pair<double, double>& ends, const std::string& words) {
    document.add(steady_item(
        {"Between ", varied_quantity(branch, ends.first, 6), " and ", varied_quantity(branch, ends.second, 6), words}));
  };
  for (const auto& ends : nonlinear::without_stable_motion(branch))
    add_stretch(ends, " no stable motion is known; the largest values leave it out, and motions there may exceed them");
  for (const auto& ends : nonlinear::quasi_periodic_stretches(branch))
    add_stretch(ends,
                " a motion has lost its stability to quasi-periodic ones, which are not computed; the largest values "
                "leave them out, and they may exceed them");
  const std::vector<Jump> jumps = jumps_of(branch);
  document.add(jump_table(branch, jumps));
  using Kind = nonlinear::StabilityChange::Kind;
  if (!jumps.empty() && std::ranges::count(branch.changes, Kind::quasi_periodic, &nonlinear::StabilityChange::kind) > 0)
    document.add(steady_item({"Quasi-periodic motions are not computed; a jump may end in one"}));
  if (branch.results.size() > 1 && !jumps.empty()) {
    Table& all = document.add(jump_table(branch, with_all_results(branch, jumps)));
    all.title = "All results before and after each jump";
    all.folded = true;
    all.forms = on_page;
  }
  document.add(stable_table(branch));
}

}  // namespace trivet::results
