// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/stable_motions.h"

#include <algorithm>
#include <cmath>

namespace trivet::nonlinear {

std::vector<const SteadyPoint*> stable_points(const SteadyBranch& branch) {
  std::vector<const SteadyPoint*> stable;
  for (const SteadyPoint& point : branch.points)
    if (point.stable) stable.push_back(&point);
  for (const Fold& fold : branch.folds) {
    const std::size_t next = std::min(fold.after + 1, branch.points.size() - 1);
    if (branch.points[fold.after].stable || branch.points[next].stable) stable.push_back(&fold.point);
  }
  for (const SteadyBranch& curve : branch.further) {
    const std::vector<const SteadyPoint*> more = stable_points(curve);
    stable.insert(stable.end(), more.begin(), more.end());
  }
  return stable;
}

namespace {

using Stretch = std::pair<double, double>;

void add_stable_stretches(const SteadyBranch& branch, std::vector<Stretch>& stretches) {
  const auto add = [&](const SteadyPoint& a, const SteadyPoint& b) {
    stretches.emplace_back(std::minmax({branch.parameter(a), branch.parameter(b)}));
  };
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
    const SteadyPoint &here = branch.points[i], &next = branch.points[i + 1];
    const auto in_step = [i](const auto& one) { return one.after == i; };
    const auto fold = std::find_if(branch.folds.begin(), branch.folds.end(), in_step);
    const auto change = std::find_if(branch.changes.begin(), branch.changes.end(), in_step);
    const SteadyPoint* middle = fold != branch.folds.end() ? &fold->point
        : change != branch.changes.end()                   ? &change->point
                                                           : nullptr;
    if (!middle && here.stable && next.stable) add(here, next);
    if (middle && here.stable) add(here, *middle);
    if (middle && next.stable) add(*middle, next);
  }
  // A curve begins where the harmonics have it, beside the change of stability by what they leave out.
  for (const StabilityChange& change : branch.changes) {
    if (!change.curve || *change.curve >= branch.further.size()) continue;
    const SteadyBranch& curve = branch.further[*change.curve];
    const double at = branch.parameter(change.point);
    const SteadyPoint &first = curve.points.front(), &last = curve.points.back();
    const bool is_first = std::abs(branch.parameter(first) - at) <= std::abs(branch.parameter(last) - at);
    if ((is_first ? first : last).stable) add(change.point, is_first ? first : last);
  }
}

}  // namespace

std::vector<std::pair<double, double>> without_stable_motion(const SteadyBranch& branch) {
  std::vector<Stretch> stable, without;
  add_stable_stretches(branch, stable);
  for (const SteadyBranch& curve : branch.further) add_stable_stretches(curve, stable);
  std::sort(stable.begin(), stable.end());
  double from = branch.parameter(branch.points.front()), to = from;
  for (const SteadyPoint& point : branch.points) {
    from = std::min(from, branch.parameter(point));
    to = std::max(to, branch.parameter(point));
  }
  double covered = from;
  constexpr double same = 1e-5;  // a curve begins where the harmonics have it, beside the change of stability
  for (const auto& [low, high] : stable) {
    if (low > covered * (1 + same)) without.emplace_back(covered, std::min(low, to));
    covered = std::max(covered, high);
    if (covered >= to) break;
  }
  if (covered < to * (1 - same)) without.emplace_back(covered, to);
  return without;
}

bool jumps_at(const SteadyBranch& curve, const Fold& fold) {
  return curve.points[fold.after].stable ||
      (fold.after + 1 < curve.points.size() && curve.points[fold.after + 1].stable);
}

std::vector<StableExtremes> stable_extremes(const SteadyBranch& branch) {
  const std::vector<const SteadyPoint*> stable = stable_points(branch);
  std::vector<StableExtremes> found;
  if (stable.empty()) return found;
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    StableExtremes one{stable.front()};
    for (const SteadyPoint* point : stable)
      if (point->results[c].largest > one.at->results[c].largest) one.at = point;
    one.largest = one.largest_of_all = one.at->results[c].largest;
    one.smallest = one.at->results[c].smallest;
    for (const SteadyPoint* point : stable) one.smallest = std::min(one.smallest, point->results[c].smallest);
    const auto add_all = [&](const SteadyBranch& curve) {
      for (const SteadyPoint& point : curve.points)
        one.largest_of_all = std::max(one.largest_of_all, point.results[c].largest);
    };
    add_all(branch);
    for (const SteadyBranch& curve : branch.further) add_all(curve);
    constexpr double round_off = 1e-12;  // of a stop that is not touched, or that does not pull
    for (double* end : {&one.largest, &one.smallest})
      if (std::abs(*end) <= round_off * std::max(std::abs(one.largest), std::abs(one.smallest))) *end = 0;
    found.push_back(one);
  }
  return found;
}

}  // namespace trivet::nonlinear
