// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/branched_motions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

int periods_of(const StabilityChange& change) { return change.kind == StabilityChange::Kind::period_doubling ? 2 : 1; }

/// The place near a change of stability where the equations are singular. Both are the same, but for what the harmonics
/// leave out.
std::optional<SteadyEquations::Place> crossing_near(const StabilityChange& change, const SteadyPath& connected,
                                                    const SteadyPath& seen, bool over_frequency) {
  const bool doubles = periods_of(change) == 2;
  const auto place_of = [&](const Eigen::MatrixXd& motion, double parameter) -> SteadyEquations::Place {
    return {seen.balance().unknowns_of(doubles ? over_two_periods(motion) : motion), parameter};
  };
  const auto place_on_path = [&](const numerics::BranchPoint& point) {
    return place_of(connected.balance().motion(point.unknowns), point.parameter);
  };
  const std::optional<VectorXd> direction = seen.equations().weakest_direction(
      place_of(change.point.deflections, over_frequency ? change.point.angular_frequency : change.point.load_factor));
  if (!direction) return std::nullopt;
  const auto singular = [&](const numerics::BranchPoint& point) {
    return seen.equations().change_along(place_on_path(point), *direction);
  };
  std::map<std::ptrdiff_t, double> known;  // of points
  const auto at_point = [&](std::ptrdiff_t point) {
    const auto [place, is_new] = known.try_emplace(point);
    if (is_new) place->second = singular(connected.motions().points()[point]);
    return place->second;
  };
  // Exactly there, Newton's method along the path has no unique step: as near as it converges.
  constexpr std::array<double, 4> near = {1e-6, 1e-4, 1e-2, 0.2};
  for (const int steps : {0, -1, 1, -2, 2}) {
    const std::ptrdiff_t after = to_index(change.after) + steps;
    if (after < 0 || after + 1 >= std::ssize(connected.motions().points())) continue;
    if (at_point(after) * at_point(after + 1) > 0) continue;
    const double size = std::abs(at_point(after));
    for (const double share : near)
      if (const auto found = connected.motions().zero_after(to_size(after), singular, share * size))
        return place_on_path(*found);
  }
  return std::nullopt;
}

/// Is it the other curve itself?
bool lies_on(const SteadyPath& path, const SteadyPath& other) {
  constexpr double same = 1e-3;  // of the motion
  const numerics::BranchPoint& middle = path.motions().points()[path.motions().points().size() / 2];
  const std::vector<numerics::BranchPoint> there = other.motions().all_at(middle.parameter);
  return std::ranges::any_of(there, [&](const numerics::BranchPoint& one) {
    return one.unknowns.size() == middle.unknowns.size() &&
        path.balance().are_same(one.unknowns, middle.unknowns, same);
  });
}

}  // namespace

Eigen::MatrixXd over_two_periods(const Eigen::MatrixXd& motion) {
  const Index harmonics = (motion.rows() - 1) / 2;
  Eigen::MatrixXd twice = Eigen::MatrixXd::Zero(4 * harmonics + 1, motion.cols());
  twice.row(0) = motion.row(0);
  for (Index k = 1; k <= harmonics; ++k) twice.middleRows<2>(4 * k - 1) = motion.middleRows<2>(2 * k - 1);
  return twice;
}

BranchedPaths branched_paths(const std::vector<StabilityChange>& changes, const SteadyPath& connected,
                             const ReferenceMachine& machine, const ReferenceMachine* twice,
                             const SteadyOptions& options, const foundation::Progress& progress) {
  constexpr std::size_t most = 8;  // a machine that rattles has dozens, with motions that hardly differ
  const auto new_path = [&](int periods) {
    const ReferenceMachine& seen = periods == 2 ? *twice : machine;
    return std::make_unique<SteadyPath>(seen.condensed, seen.deflections, seen.excitation, options,
                                        periods * connected.balance().harmonics());
  };
  struct Crossing {
    std::size_t change;
    SteadyEquations::Place place;
  };
  BranchedPaths found;
  for (const int periods : {1, 2}) {
    const bool any = std::ranges::any_of(changes, [&](const StabilityChange& change) {
      return change.kind != StabilityChange::Kind::quasi_periodic && periods_of(change) == periods;
    });
    if (!any) continue;
    std::vector<Crossing> crossings;
    std::unique_ptr<SteadyPath> path = new_path(periods);
    for (std::size_t i = 0; i < changes.size() && crossings.size() < most; ++i) {
      if (changes[i].kind == StabilityChange::Kind::quasi_periodic || periods_of(changes[i]) != periods) continue;
      found.sought_at.push_back(i);
      if (auto place = crossing_near(changes[i], connected, *path, options.over == Parameter::frequency))
        crossings.push_back({i, std::move(*place)});
    }
    std::vector<SteadyEquations::Place> ends;
    for (const Crossing& crossing : crossings) ends.push_back(crossing.place);
    std::vector<bool> reached(crossings.size());
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      if (reached[i]) continue;
      const std::size_t change = crossings[i].change;
      const VectorXd along = periods == 1 ? connected.motions().points()[changes[change].after].tangent : VectorXd();
      if (path->follow_branched(crossings[i].place, along, ends, progress) && !lies_on(*path, connected)) {
        std::vector<std::size_t> changes_at_ends = {change};
        if (const auto end = path->stopped_at()) {
          changes_at_ends.push_back(crossings[*end].change);
          reached[*end] = true;
        }
        found.paths.push_back({std::move(changes_at_ends), periods, std::move(path)});
      }
      path = new_path(periods);
    }
  }
  return found;
}

}  // namespace trivet::nonlinear
