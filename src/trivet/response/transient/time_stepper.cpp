// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/time_stepper.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"

namespace trivet::response {

namespace {

bool jumps_in(const InputCourse& course, InputCourse::Place place, int held) {
  for (int m = 0; m < 3; ++m)
    if ((held >> m & 1) != 0 && course.jumps(place, m)) return true;
  return false;
}

}  // namespace

Eigen::Index sample_whole_steps(const InputCourse& course, const TimeGrid& grid, Eigen::Index point, int held,
                                InputCourse::Place place, Eigen::Ref<Eigen::Matrix<double, 5, Eigen::Dynamic>> w) {
  const double resolution = grid.resolution;
  double now = grid.time(point), corner = course.next_corner(place);
  for (Eigen::Index count = 0; count < w.cols(); ++count) {
    const double to = grid.time(point + count + 1);
    const bool enters = corner <= to + resolution;
    const double after = enters ? course.next_corner(place + 1) : corner;
    if (enters &&
        (corner < to - resolution || after <= to + resolution || (held != 0 && jumps_in(course, place + 1, held))))
      return count;
    w.col(count) = course.at(place, now);
    now = to;
    if (!enters) continue;
    corner = after;
    ++place;
    if (place == 0 || course.kappa_index(place - 1) != course.kappa_index(place)) return count + 1;
  }
  return w.cols();
}

namespace {

double column_norm(const Eigen::MatrixXd& F) { return F.size() > 0 ? F.cwiseAbs().colwise().sum().maxCoeff() : 0; }

}  // namespace

ExactSteps::ExactSteps(const StateSpace& space, double step, double largest_kappa)
    : F_(space.F()), groups_(space.groups()), step_(step), fastest_(std::max(column_norm(F_), largest_kappa)) {
  const Eigen::Index P = groups_.pairs;
  pair_rates_.resize(P, 4);
  for (Eigen::Index j = 0; j < P; ++j) {
    const std::vector<Eigen::Index> at = {j, P + j};
    pairs_.emplace_back(F_(at, at), step, fastest_);
    pair_rates_.row(j) << F_(j, j), F_(j, P + j), F_(P + j, j), F_(P + j, P + j);
  }
  Eigen::Index first = 2 * P;
  for (const Eigen::Index size : groups_.dense) {
    dense_.emplace_back(F_.block(first, first, size, size), step, fastest_);
    first += size;
  }
  assert(first == F_.rows() && "every state belongs to a pair or to a dense group");
  if (!pairs_.empty() || !dense_.empty()) levels_ = (pairs_.empty() ? dense_ : pairs_).front().levels();
  [[maybe_unused]] const auto is_as_fine = [&](const ExponentialStep& one) { return one.levels() == levels_; };
  assert(std::ranges::all_of(pairs_, is_as_fine) && std::ranges::all_of(dense_, is_as_fine) &&
         "halvings depend on the fastest rate of all states");
  for (std::size_t level = 0; level < levels_ && P > 0; ++level) pair_matrices_.push_back(pair_matrix(level));
}

Eigen::ArrayXXd ExactSteps::pair_matrix(std::size_t level) const {
  Eigen::ArrayXXd matrix(groups_.pairs, 4);
  for (Eigen::Index j = 0; j < groups_.pairs; ++j) {
    const Eigen::MatrixXd& phi = pairs_[j].state(level);
    matrix.row(j) << phi(0, 0), phi(0, 1), phi(1, 0), phi(1, 1);
  }
  return matrix;
}

std::vector<InputMatrix> ExactSteps::input(const InputMatrix& G, double kappa) const {
  std::vector<InputMatrix> result(levels_, InputMatrix::Zero(G.rows(), 5));
  const Eigen::Index P = groups_.pairs;
  for (Eigen::Index j = 0; j < P; ++j) {
    InputMatrix own(2, 5);
    own << G.row(j), G.row(P + j);
    if (own.isZero(0)) continue;
    const std::vector<InputMatrix> gamma = pairs_[j].input(own, kappa);
    for (std::size_t level = 0; level < levels_; ++level) {
      result[level].row(j) = gamma[level].row(0);
      result[level].row(P + j) = gamma[level].row(1);
    }
  }
  Eigen::Index first = 2 * P;
  for (std::size_t g = 0; g < dense_.size(); ++g) {
    const Eigen::Index size = groups_.dense[g];
    const std::vector<InputMatrix> gamma = dense_[g].input(G.middleRows(first, size), kappa);
    for (std::size_t level = 0; level < levels_; ++level) result[level].middleRows(first, size) = gamma[level];
    first += size;
  }
  return result;
}

void ExactSteps::take(std::size_t level, const std::vector<numerics::StepInput>& inputs,
                      const Eigen::Ref<const Eigen::MatrixXd>& w, Eigen::Ref<Eigen::MatrixXd> states) const {
  const Eigen::Index P = groups_.pairs;
  if (P > 0)
    numerics::take_pair_steps({P, pair_matrices_[level].data(), inputs.data(), inputs.data() + inputs.size()}, w,
                              states);
  Eigen::Index first = 2 * P;
  for (std::size_t g = 0; g < dense_.size(); ++g) {
    const Eigen::Index size = groups_.dense[g];
    for (Eigen::Index i = 0; i < w.cols(); ++i) {
      auto next = states.col(i + 1).segment(first, size);
      next.noalias() = dense_[g].state(level) * states.col(i).segment(first, size);
      for (const numerics::StepInput& input : inputs)
        next += w(input.row, i) * Eigen::Map<const Eigen::VectorXd>(input.gamma + first, size);
    }
    first += size;
  }
}

void ExactSteps::rate(const Eigen::VectorXd& x, Eigen::VectorXd& result) const {
  const Eigen::Index P = groups_.pairs;
  for (Eigen::Index j = 0; j < P; ++j) {
    const double one = x(j), two = x(P + j);
    result(j) = pair_rates_(j, 0) * one + pair_rates_(j, 1) * two;
    result(P + j) = pair_rates_(j, 2) * one + pair_rates_(j, 3) * two;
  }
  Eigen::Index first = 2 * P;
  for (const Eigen::Index size : groups_.dense) {
    result.segment(first, size).noalias() = F_.block(first, first, size, size) * x.segment(first, size);
    first += size;
  }
}

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
