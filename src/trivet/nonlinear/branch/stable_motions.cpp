// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/stable_motions.h"

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
    const auto fold = std::ranges::find_if(branch.folds, in_step);
    const auto change = std::ranges::find_if(branch.changes, in_step);
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
  std::ranges::sort(stable);
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

namespace {

void add_quasi_periodic(const SteadyBranch& curve, std::vector<Stretch>& stretches) {
  const auto count = static_cast<std::ptrdiff_t>(curve.points.size());
  const auto ends_in_step = [&](std::ptrdiff_t step) {
    const auto in_step = [step](const auto& one) { return static_cast<std::ptrdiff_t>(one.after) == step; };
    return std::ranges::any_of(curve.folds, in_step) || std::ranges::any_of(curve.changes, in_step);
  };
  for (const StabilityChange& change : curve.changes) {
    if (change.kind != StabilityChange::Kind::quasi_periodic) continue;
    const auto before = static_cast<std::ptrdiff_t>(change.after);
    const bool begins_before = !curve.points[change.after].stable;  // it is unstable before the change
    double from = curve.parameter(change.point), to = from;
    for (std::ptrdiff_t i = begins_before ? before : before + 1; i >= 0 && i < count; i += begins_before ? -1 : 1) {
      const SteadyPoint& point = curve.points[static_cast<std::size_t>(i)];
      if (point.stable) break;
      from = std::min(from, curve.parameter(point));
      to = std::max(to, curve.parameter(point));
      if (ends_in_step(begins_before ? i - 1 : i)) break;
    }
    stretches.emplace_back(from, to);
  }
}

}  // namespace

std::vector<std::pair<double, double>> quasi_periodic_stretches(const SteadyBranch& branch) {
  std::vector<Stretch> all, merged;
  add_quasi_periodic(branch, all);
  for (const SteadyBranch& curve : branch.further) add_quasi_periodic(curve, all);
  const std::vector<Stretch> without = without_stable_motion(branch);
  std::erase_if(all, [&](const Stretch& one) {
    return std::ranges::any_of(
        without, [&](const Stretch& other) { return other.first <= one.first && one.second <= other.second; });
  });
  std::ranges::sort(all);
  for (const Stretch& one : all)
    if (!merged.empty() && one.first <= merged.back().second)
      merged.back().second = std::max(merged.back().second, one.second);
    else merged.push_back(one);
  return merged;
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
    const auto farthest = [c](const SteadyPoint& point) {
      return std::max(point.results[c].largest, -point.results[c].smallest);
    };
    StableExtremes one{stable.front(), stable.front()->results[c].largest, stable.front()->results[c].smallest};
    for (const SteadyPoint* point : stable) {
      if (farthest(*point) > farthest(*one.at)) one.at = point;
      one.largest = std::max(one.largest, point->results[c].largest);
      one.smallest = std::min(one.smallest, point->results[c].smallest);
    }
    one.farthest_of_all = farthest(*one.at);
    const auto add_all = [&](const SteadyBranch& curve) {
      for (const SteadyPoint& point : curve.points)
        one.farthest_of_all = std::max(one.farthest_of_all, farthest(point));
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
