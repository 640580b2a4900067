// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/transient_record.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

/// Points searched per extreme; more would change the last digits only.
constexpr std::size_t most_searches = 32;
constexpr int most_halvings = 60;
constexpr double round_off_of_bends = 1e-9;

/// Largest value of one result (of −result for the smallest) near a point.
class Search {
 public:
  Search(TimeStepper& stepper, const StateSpace& space, const LinearRows& row, double sign)
      : stepper_(stepper), value_(row), rate_(space.derivative(row)), sign_(sign), inputs_(row.on_input.cols()) {}

  /// Searches between `state` and `end`, across corners.
  void over(StepperState state, double end, Extreme& best) {
    while (end - state.time > stepper_.resolution()) {
      const double to = std::min(end, stepper_.next_corner(state));
      StepperState after = state;
      stepper_.advance_to_corner(after, to);
      offer(after, best);
      if (signed_value(rate_, state) > 0 && signed_value(rate_, after) < 0) raise_at_turn(state, to, best);
      stepper_.apply_corners(after);
      offer(after, best);
      state = std::move(after);
    }
  }

 private:
  double signed_value(const LinearRows& row, const StepperState& at) {
    stepper_.inputs(at, inputs_);
    return sign_ * (row.on_state.row(0).dot(at.x) + row.on_input.row(0).dot(inputs_));
  }
  void offer(const StepperState& at, Extreme& best) {
    const double value = signed_value(value_, at);
    if (value > sign_ * best.value) best = {sign_ * value, at.time};
  }
  /// The derivative is positive at `state` and negative at `end`: regula falsi, Illinois variant.
  void raise_at_turn(const StepperState& state, double end, Extreme& best) {
    StepperState here = state;
    double low = state.time, high = end, at_low = signed_value(rate_, state);
    stepper_.advance_to_corner(here, end);
    double at_high = signed_value(rate_, here);
    assert(at_low > 0 && at_high < 0 && "the derivative changes its sign in between");
    for (int i = 0, side = 0;
         i < most_halvings && high - low > std::max(stepper_.resolution(), 1e-7 * (end - state.time)); ++i) {
      const double t = std::clamp(low + (high - low) * at_low / (at_low - at_high), low + 1e-3 * (high - low),
                                  high - 1e-3 * (high - low));
      here = state;
      stepper_.advance_to_corner(here, t);
      offer(here, best);
      const double rate = signed_value(rate_, here);
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

  TimeStepper& stepper_;
  const LinearRows& value_;
  LinearRows rate_;
  double sign_;
  Eigen::VectorXd inputs_;
};

struct Candidate {
  double reach = 0;
  Eigen::Index point = 0;
};

/// Points near which the curve may exceed its extremes: by `margin` times the rise of the parabola through a turning
/// point and its neighbours.
struct Candidates {
  std::vector<Candidate> largest, smallest;  ///< largest reach first; −value for the smallest
};

/// A turning point rises above its value by an eighth of the bend at most, so few blocks have candidates.
Candidates candidates(const TimeCurve& curve, const std::vector<numerics::RowBlock>& blocks, Eigen::Index every,
                      double margin) {
  Candidates found;
  const Eigen::VectorXd& v = curve.values;
  const Eigen::Index last = v.size() - 1;
  const auto add = [&](double rise, Eigen::Index i, bool up) {
    const double reach = (up ? v(i) : -v(i)) + rise;
    if (reach > (up ? curve.largest.value : -curve.smallest.value))
      (up ? found.largest : found.smallest).push_back({reach, i});
  };
  for (const auto& [end, inner] : {std::pair{Eigen::Index{0}, Eigen::Index{1}}, {last, last - 1}})
    add(std::abs(v(end) - v(inner)), end, v(end) > v(inner));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double bend = std::max(blocks[b].bend, b + 1 < blocks.size() ? blocks[b + 1].bend : 0),
                 rise = (1 + round_off_of_bends) * margin * bend / 8;
    if (blocks[b].largest + rise <= curve.largest.value && blocks[b].smallest - rise >= curve.smallest.value) continue;
    const Eigen::Index first = to_index(b) * every;
    for (Eigen::Index i = std::max<Eigen::Index>(first, 1); i < std::min(first + every, last); ++i) {
      if (v(i) + rise <= curve.largest.value && v(i) - rise >= curve.smallest.value) continue;
      const double before = v(i) - v(i - 1), after = v(i + 1) - v(i);
      if (before * after > 0) continue;
      const double bend_here = after - before, slope = (after + before) / 2;
      if (bend_here != 0) add(margin * slope * slope / (2 * std::abs(bend_here)), i, bend_here < 0);
    }
  }
  for (std::vector<Candidate>* list : {&found.largest, &found.smallest}) {
    const auto kept = static_cast<std::ptrdiff_t>(std::min(list->size(), most_searches));
    std::partial_sort(list->begin(), list->begin() + kept, list->end(),
                      [](const Candidate& a, const Candidate& b) { return a.reach > b.reach; });
    list->resize(to_size(kept));
  }
  return found;
}

}  // namespace

void search_between_points(TimeStepper& stepper, const StateSpace& space, const LinearRows& row, std::size_t index,
                           const TimeGrid& grid, const TimeBlocks& blocks, const foundation::Progress& progress,
                           TimeCurve& curve) {
  // For a sine with phase θ between points, the parabola has (1 + cos θ)/2 of the rise; a quarter more for other
  // motions.
  const double phase = std::min(grid.fastest * grid.step, 2.5);
  const Candidates found = candidates(curve, blocks.of_curve[index], blocks.every, 2.5 / (1 + std::cos(phase)));
  std::size_t done = 0;
  const std::size_t all = found.largest.size() + found.smallest.size();
  for (const double sign : {1.0, -1.0}) {
    Extreme& best = sign > 0 ? curve.largest : curve.smallest;
    Search search(stepper, space, row, sign);
    for (const Candidate& candidate : sign > 0 ? found.largest : found.smallest) {
      if (candidate.reach <= sign * best.value) break;
      foundation::report_progress(progress, "largest and smallest values",
                                  static_cast<double>(done++) / static_cast<double>(all));
      const Eigen::Index first = std::max<Eigen::Index>(candidate.point - 1, 0),
                         last = std::min(candidate.point + 1, grid.points - 1);
      const Eigen::Index block = first / blocks.every;
      StepperState state = stepper.state_at(grid.time(block * blocks.every), blocks.states.col(block));
      for (Eigen::Index i = block * blocks.every; i < first; ++i) stepper.advance(state, grid.time(i + 1));
      for (Eigen::Index i = first; i < last; ++i) {
        search.over(state, grid.time(i + 1), best);
        stepper.advance(state, grid.time(i + 1));
      }
    }
  }
}

}  // namespace trivet::response
