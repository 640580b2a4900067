// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient_extremes.h"

#include <algorithm>
#include <cmath>

namespace trivet::response {
namespace {

/// Walks taken again per extreme; what is left by then differs in the last digits only.
constexpr std::size_t most_searches = 32;
constexpr int most_halvings = 60;

/// Largest value of one answer (of −answer for the smallest) near a point.
class Search {
 public:
  Search(TransientWalk& walk, const StateSpace& space, const LinearRows& row, double sign)
      : walk_(walk), value_(row), rate_(space.derivative(row)), sign_(sign), inputs_(row.on_input.cols()) {}

  /// Between `state` and `end`, corners taken on the way.
  void over(WalkState state, double end, Extreme& best) {
    while (end - state.time > walk_.resolution()) {
      const double to = std::min(end, walk_.next_corner(state));
      WalkState after = state;
      walk_.glide(after, to);
      offer(after, best);
      if (of(rate_, state) > 0 && of(rate_, after) < 0) turn(state, to, best);
      walk_.take_corners(after);
      offer(after, best);
      state = std::move(after);
    }
  }

 private:
  double of(const LinearRows& row, const WalkState& at) {
    walk_.inputs(at, inputs_);
    return sign_ * (row.on_state.row(0).dot(at.x) + row.on_input.row(0).dot(inputs_));
  }
  void offer(const WalkState& at, Extreme& best) {
    const double value = of(value_, at);
    if (value > sign_ * best.value) best = {sign_ * value, at.time};
  }
  /// The derivative is positive at `state` and negative at `end`: regula falsi with the weights of Illinois.
  void turn(const WalkState& state, double end, Extreme& best) {
    WalkState here = state;
    double low = state.time, high = end, at_low = of(rate_, state);
    walk_.glide(here, end);
    double at_high = of(rate_, here);
    for (int i = 0, side = 0; i < most_halvings && high - low > std::max(walk_.resolution(), 1e-7 * (end - state.time)); ++i) {
      const double t = std::clamp(low + (high - low) * at_low / (at_low - at_high), low + 1e-3 * (high - low), high - 1e-3 * (high - low));
      here = state;
      walk_.glide(here, t);
      offer(here, best);
      const double rate = of(rate_, here);
      if (rate == 0) return;
      if (rate > 0) {
        low = t, at_low = rate;
        if (side == 1) at_high /= 2;
        side = 1;
      } else {
        high = t, at_high = rate;
        if (side == -1) at_low /= 2;
        side = -1;
      }
    }
  }

  TransientWalk& walk_;
  const LinearRows& value_;
  LinearRows rate_;
  double sign_;
  Eigen::VectorXd inputs_;
};

struct Candidate {
  double reach = 0;
  Eigen::Index point = 0;
};

/// Points next to which the curve may exceed `best`: the parabola through a highest point and its neighbours, with a quarter more rise.
std::vector<Candidate> candidates(const Eigen::VectorXd& v, double sign, double best) {
  std::vector<Candidate> found;
  const Eigen::Index last = v.size() - 1;
  for (Eigen::Index i = 0; i <= last; ++i) {
    const double here = sign * v(i), before = sign * v(std::max<Eigen::Index>(i - 1, 0)), after = sign * v(std::min(i + 1, last));
    if (here < before || here < after) continue;
    double reach = here;
    if (i > 0 && i < last) {
      const double bend = before - 2 * here + after, slope = (after - before) / 2;
      if (bend < 0) reach -= 1.25 * slope * slope / (2 * bend);
    } else {
      reach += std::abs(before - after);
    }
    if (reach > best) found.push_back({reach, i});
  }
  const auto kept = static_cast<std::ptrdiff_t>(std::min(found.size(), most_searches));
  std::partial_sort(found.begin(), found.begin() + kept, found.end(), [](const Candidate& a, const Candidate& b) { return a.reach > b.reach; });
  found.resize(static_cast<std::size_t>(kept));
  return found;
}

}  // namespace

void search_between_points(TransientWalk& walk, const StateSpace& space, const LinearRows& row, const TimeGrid& grid, const Checkpoints& checkpoints,
                           TimeCurve& curve) {
  for (const double sign : {1.0, -1.0}) {
    Extreme& best = sign > 0 ? curve.largest : curve.smallest;
    Search search(walk, space, row, sign);
    for (const Candidate& candidate : candidates(curve.values, sign, sign * best.value)) {
      if (candidate.reach <= sign * best.value) break;
      const Eigen::Index first = std::max<Eigen::Index>(candidate.point - 1, 0), last = std::min(candidate.point + 1, grid.points - 1);
      WalkState state = checkpoints.states[static_cast<std::size_t>(first / checkpoints.every)];
      for (Eigen::Index i = first / checkpoints.every * checkpoints.every; i < first; ++i) walk.advance(state, grid.time(i + 1));
      for (Eigen::Index i = first; i < last; ++i) {
        search.over(state, grid.time(i + 1), best);
        walk.advance(state, grid.time(i + 1));
      }
    }
  }
}

}  // namespace trivet::response
