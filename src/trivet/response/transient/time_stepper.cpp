// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/time_stepper.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/response/transient/whole_steps.h"

namespace trivet::response {

TimeStepper::TimeStepper(const StateSpace& space, const std::vector<InputCourse>& courses, double step,
                         double resolution)
    : space_(space),
      courses_(courses),
      resolution_(resolution),
      steps_(space, step, largest_kappa(courses)),
      gamma_(courses.size()),
      two_(space.size(), 2),
      w_(to_index(courses.size()) * 5),
      next_(space.size()),
      term_(space.size()),
      own_(courses.size()) {
  for (std::size_t c = 0; c < courses.size(); ++c) gamma_[c].resize(courses[c].kappas().size());
}

const TimeStepper::Gamma& TimeStepper::gamma(std::size_t course, std::size_t kappa) {
  Gamma& known = gamma_[course][kappa];
  if (!known.levels.empty()) return known;
  known.levels = steps_.input(space_.G(course), courses_[course].kappas()[kappa]);
  for (Eigen::Index m = 0; m < 5; ++m)
    if (!known.levels[0].col(m).isZero(0) && !(m == of_value + 2 && courses_[course].is_polygon()))
      known.columns.push_back(m);
  return known;
}

void TimeStepper::find_inputs(const StepperState& at, std::size_t level) {
  inputs_.clear();
  for (std::size_t c = 0; c < courses_.size(); ++c) {
    if (at.places[c] < 0) continue;
    const Gamma& own = gamma(c, courses_[c].kappa_index(at.places[c]));
    for (const Eigen::Index m : own.columns) inputs_.push_back({own.levels[level].col(m).data(), to_index(c) * 5 + m});
  }
}

double TimeStepper::next_corner(const StepperState& at) const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < courses_.size(); ++c) next = std::min(next, courses_[c].next_corner(at.places[c]));
  return next;
}

void TimeStepper::advance_to_corner(StepperState& at, double to) {
  assert(to >= at.time - resolution_ && at.places.size() == courses_.size());
  if (std::abs(to - at.time - steps_.step()) <= resolution_) apply_step(at, 0);
  for (std::size_t level = 1; level < steps_.levels() && to - at.time > resolution_; ++level)
    if (std::ldexp(steps_.step(), -static_cast<int>(level)) <= to - at.time) apply_step(at, level);
  if (to - at.time > resolution_) apply_series(at, to - at.time);
  at.time = to;
}

void TimeStepper::apply_step(StepperState& at, std::size_t level) {
  assert(level < steps_.levels());
  find_inputs(at, level);
  for (std::size_t c = 0; c < courses_.size(); ++c)
    w_.segment<5>(to_index(c) * 5) = courses_[c].at(at.places[c], at.time);
  two_.col(0) = at.x;
  steps_.take(level, inputs_, w_, two_);
  at.x = two_.col(1);
  at.time += std::ldexp(steps_.step(), -static_cast<int>(level));
}

Eigen::Index TimeStepper::take_whole_steps(StepperState& at, const TimeGrid& grid, Eigen::Index point,
                                           const std::vector<int>& held, Eigen::Ref<Eigen::MatrixXd> states,
                                           Eigen::Ref<Eigen::MatrixXd> w) {
  find_inputs(at, 0);
  Eigen::Index count = w.cols();
  for (std::size_t c = 0; c < courses_.size() && count > 0; ++c) {
    count = sample_whole_steps(courses_[c], grid, point, held[c], at.places[c], w.block(to_index(c) * 5, 0, 5, count));
  }
  if (count == 0) return 0;
  steps_.take(0, inputs_, w.leftCols(count), states.leftCols(count + 1));
  at = state_at(grid.time(point + count), states.col(count));
  return count;
}

StepperState TimeStepper::state_at(double time, const Eigen::VectorXd& x) const {
  StepperState state{time, x, {}};
  for (const InputCourse& course : courses_) state.places.push_back(course.place_at(time, resolution_));
  return state;
}

void TimeStepper::apply_series(StepperState& at, double duration) {
  // Halved steps leave less than the finest one, with half a radian of the fastest rate.
  assert(duration > 0 && steps_.fastest() * duration <= 0.5 * (1 + 1e-6));
  for (std::size_t c = 0; c < courses_.size(); ++c) own_[c] = courses_[c].at(at.places[c], at.time);
  term_ = at.x;
  constexpr double none = 1e-25;  // the bound of the last term if the norm is 1/2
  double bound = 1;
  for (int k = 1; k <= series_terms && bound > none; ++k) {
    const double by = duration / k;
    bound *= steps_.fastest() * by;
    steps_.rate(term_, next_);
    for (std::size_t c = 0; c < courses_.size(); ++c) {
      if (own_[c].isZero(0)) continue;  // a polynomial ends after a few terms
      next_.noalias() += space_.G(c) * own_[c];
      own_[c] = rate(own_[c], courses_[c].kappa(at.places[c])) * by;
    }
    term_ = next_ * by;
    at.x += term_;
  }
}

void TimeStepper::apply_corners(StepperState& at) const {
  for (std::size_t c = 0; c < courses_.size(); ++c)
    while (courses_[c].next_corner(at.places[c]) <= at.time + resolution_) {
      ++at.places[c];
      if (state_jumps(c)) at.x += space_.jump(c, courses_[c].jump_into(at.places[c]));
    }
}

void TimeStepper::advance(StepperState& at, double to) {
  while (to - at.time > resolution_) {
    const double next = std::min({to, at.time + steps_.step(), next_corner(at)});
    advance_to_corner(at, next);
    apply_corners(at);
  }
}

void TimeStepper::inputs(const StepperState& at, Eigen::Ref<Eigen::VectorXd> derivatives) const {
  for (std::size_t c = 0; c < courses_.size(); ++c)
    derivatives.segment<input_derivatives>(to_index(c) * input_derivatives) =
        all_derivatives(courses_[c].at(at.places[c], at.time), courses_[c].kappa(at.places[c]));
}

}  // namespace trivet::response
