// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/time_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"

namespace trivet::response {

TimeStepper::TimeStepper(const StateSpace& space, const std::vector<InputCourse>& courses, double step,
                         double resolution)
    : space_(space),
      courses_(courses),
      resolution_(resolution),
      exponential_(space.F(), step, largest_kappa(courses)),
      gamma_(courses.size()),
      next_(space.size()),
      term_(space.size()),
      own_(courses.size()) {
  for (std::size_t c = 0; c < courses.size(); ++c) gamma_[c].resize(courses[c].kappas().size());
}

const std::vector<InputMatrix>& TimeStepper::gamma(std::size_t course, std::size_t kappa) {
  std::vector<InputMatrix>& known = gamma_[course][kappa];
  if (known.empty()) known = exponential_.input(space_.G(course), courses_[course].kappas()[kappa]);
  return known;
}

double TimeStepper::next_corner(const StepperState& at) const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < courses_.size(); ++c) next = std::min(next, courses_[c].next_corner(at.places[c]));
  return next;
}

void TimeStepper::advance_to_corner(StepperState& at, double to) {
  if (std::abs(to - at.time - exponential_.step()) <= resolution_) apply_step(at, 0);
  for (std::size_t level = 1; level < exponential_.levels() && to - at.time > resolution_; ++level)
    if (std::ldexp(exponential_.step(), -static_cast<int>(level)) <= to - at.time) apply_step(at, level);
  if (to - at.time > resolution_) apply_series(at, to - at.time);
  at.time = to;
}

void TimeStepper::apply_step(StepperState& at, std::size_t level) {
  next_.noalias() = exponential_.state(level) * at.x;
  for (std::size_t c = 0; c < courses_.size(); ++c)
    if (at.places[c] >= 0)
      next_.noalias() += gamma(c, courses_[c].kappa_index(at.places[c]))[level] * courses_[c].at(at.places[c], at.time);
  at.x.swap(next_);
  at.time += std::ldexp(exponential_.step(), -static_cast<int>(level));
}

void TimeStepper::apply_series(StepperState& at, double duration) {
  for (std::size_t c = 0; c < courses_.size(); ++c) own_[c] = courses_[c].at(at.places[c], at.time);
  term_ = at.x;
  for (int k = 1; k <= series_terms; ++k) {
    const double by = duration / k;
    next_.noalias() = space_.F() * term_;
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
    const double next = std::min({to, at.time + exponential_.step(), next_corner(at)});
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
