// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rubbing_loop.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using foundation::two_pi;

namespace {

constexpr double round_off = 1e-12;

}  // namespace

RubbingLoop::RubbingLoop(const RubbingAbout& law, const MatrixXd& course, const std::vector<double>& corners,
                         double omega, double longest)
    : law_(law),
      course_(course),
      slope_(numerics::phase_derivatives(course)),
      bend_(numerics::phase_derivatives(slope_)),
      omega_(omega) {
  std::vector<double> ends = corners;
  if (ends.empty()) ends = {0};
  const auto is_open = [&](std::size_t i) {
    const double to = i + 1 < ends.size() ? ends[i + 1] : ends.front() + two_pi;
    return at((ends[i] + to) / 2).limit.value == 0;
  };
  // From the start of an open stretch, at the end of which there is no force.
  std::size_t first = 0;
  while (first < ends.size() && !is_open(first)) ++first;
  opens_ = first < ends.size();
  if (opens_ && corners.size() < 2) return;
  if (opens_) {
    std::rotate(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(first), ends.end());
    for (double& end : ends)
      if (end < ends.front()) end += two_pi;
  }
  longest = std::min(longest, step_of_stiffness());
  const double start = ends.front();
  ends.erase(ends.begin());
  ends.push_back(start + two_pi);
  if (opens_) {
    begin(start, Vector2d::Zero());
    march(ends, longest);
  } else if (!settles(start, ends, longest)) {
    close(start, ends, longest);
  }
}

/// Under slip the force follows the travel within a travel of L/k: from node to node at most a quarter of that at the
/// largest limit, if this needs no more than eight times the usual nodes.
double RubbingLoop::step_of_stiffness() const {
  constexpr int samples = 32, nodes = 8, most = 512;
  double fastest = 0, largest = 0;
  for (int i = 0; i < samples; ++i) {
    const Here here = at(two_pi * i / samples);
    fastest = std::max(fastest, law_.law().stiffness * here.across_slope.norm());
    largest = std::max(largest, here.limit.value);
  }
  return fastest > 0 ? std::max(two_pi / most, nodes * largest / fastest / 4) : two_pi;
}

RubbingLoop::Here RubbingLoop::at(double phase) const {
  const Eigen::RowVectorXd row = numerics::fourier_row((course_.rows() - 1) / 2, phase);
  const Eigen::RowVector3d value = row * course_, slope = row * slope_;
  const RubbingAbout::Limit limit = law_.limit(value(0), omega_ * slope(0));
  return {value.tail<2>().transpose(), slope.tail<2>().transpose(), limit,
          limit.by_deflection * slope(0) + limit.by_rate * omega_ * row.dot(bend_.col(0))};
}

/// Does it stick all the time, with the springs at the place where their forces stay farthest below their limits?
bool RubbingLoop::settles(double start, const std::vector<double>& ends, double longest) {
  begin(start, Vector2d::Zero());
  double from = start;
  for (const double to : ends) {
    if (to - from > round_off) append_nodes(from, to, longest, false);
    from = to;
  }
  const double k = law_.law().stiffness;
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < points_.size(); ++i) discs.push_back({across_[i], points_[i].limit.value / k});
  place_ = deepest_place(discs);
  always_sticks_ = place_.beyond <= 0;
  for (std::size_t i = 0; i < points_.size(); ++i) points_[i].force = k * (across_[i] - place_.place);
  return always_sticks_;
}

/// By Newton's method on the force at the start.
void RubbingLoop::close(double start, const std::vector<double>& ends, double longest) {
  const Here here = at(start);
  Vector2d force = law_.law().stiffness * (here.across - place_.place);
  if (const double size = force.norm(); size > here.limit.value) force *= here.limit.value / size;
  constexpr int most = 60;
  for (int i = 0; i < most; ++i) {
    begin(start, force);
    march(ends, longest);
    const Vector2d missing = points_.back().force - force;
    double largest = 0;
    for (const Point& point : points_) largest = std::max(largest, point.limit.value);
    if (missing.norm() <= round_off * largest) return;
    const Matrix2d left = Matrix2d::Identity() - kept();
    constexpr double singular = 1e-12;
    const double determinant = left(0, 0) * left(1, 1) - left(0, 1) * left(1, 0), limit = points_.front().limit.value;
    Matrix2d inverse;
    inverse << left(1, 1), -left(0, 1), -left(1, 0), left(0, 0);
    if (std::abs(determinant) > singular) force += inverse * missing / determinant;
    else force = points_.back().force;
    if (const double size = force.norm(); size > limit) force *= limit / size;
  }
  // Not closed: no motion is found with it.
  for (Point& point : points_) point.force.setConstant(std::numeric_limits<double>::quiet_NaN());
}

void RubbingLoop::begin(double start, const Vector2d& force) {
  points_.clear();
  across_.clear();
  const Here here = at(start);
  points_.push_back({start, 0, force, State::open, here.limit, {}});
  across_.push_back(here.across);
}

void RubbingLoop::march(const std::vector<double>& ends, double longest) {
  double from = ends.back() - two_pi;
  for (const double to : ends) {
    if (to - from > round_off) {
      if (at((from + to) / 2).limit.value > 0) {
        rub(from, to, longest);
      } else {
        points_.push_back({to, 0, Vector2d::Zero(), State::open, {}, {}});
        across_.push_back(at(to).across);
      }
    }
    from = to;
  }
}

void RubbingLoop::rub(double from, double to, double longest) {
  bool slips = slips_from(from, to);
  const int panels = std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
  const double length = (to - from) / panels;
  double place = from;
  for (int p = 1; p <= panels; ++p) {
    const double end = p == panels ? to : from + p * length;
    constexpr int most_changes = 20;
    for (int change = 0; place < end; ++change) {
      const double next = change < most_changes ? first_change(place, end, slips) : end;
      append_nodes(place, next, 2 * length, slips);
      if (next < end) slips = !slips;
      place = next;
    }
  }
}

/// Does it slip just after a phase?
bool RubbingLoop::slips_from(double from, double to) const {
  constexpr double soon = 1e-6;
  const Here here = at(from + soon * (to - from));
  const Vector2d force = points_.back().force + law_.law().stiffness * (here.across - across_.back());
  return force.norm() > here.limit.value;
}

/// Has the state changed, from the last point to a phase?
bool RubbingLoop::has_changed(double phase, bool slips) const {
  const Here here = at(phase);
  const double k = law_.law().stiffness;
  const Vector2d& force = points_.back().force;
  const Vector2d travel = here.across - across_.back();
  if (!slips) return (force + k * travel).norm() > here.limit.value * (1 + round_off);
  const Vector2d there = elements::slip(k, force, travel, points_.back().limit.value, here.limit.value).force;
  const double size = there.norm();
  if (size == 0) return false;
  const double pulling = k * here.across_slope.dot(there) / size;
  return pulling - here.limit_slope < -round_off * (std::abs(pulling) + std::abs(here.limit_slope));
}

double RubbingLoop::first_change(double from, double to, bool slips) const {
  constexpr int probes = 8;
  double low = from;
  for (int i = 1; i <= probes; ++i) {
    double high = i == probes ? to : from + (to - from) * i / probes;
    if (!has_changed(high, slips)) {
      low = high;
      continue;
    }
    constexpr int halvings = 60;
    for (int h = 0; h < halvings && high - low > 1e-15; ++h)
      if (const double middle = (low + high) / 2; has_changed(middle, slips)) high = middle;
      else low = middle;
    return high;
  }
  return to;
}

void RubbingLoop::append_nodes(double from, double to, double longest, bool slips) {
  std::vector<std::pair<double, double>> nodes;
  numerics::each_gauss_node(from, to, longest, [&](double phase, double weight) { nodes.emplace_back(phase, weight); });
  std::sort(nodes.begin(), nodes.end());
  for (const auto& [phase, weight] : nodes) append(phase, weight, slips);
  append(to, 0, slips);
}

void RubbingLoop::append(double phase, double weight, bool slips) {
  const Here here = at(phase);
  const double k = law_.law().stiffness;
  const Point& before = points_.back();
  Point point{phase, weight, {}, slips ? State::slips : State::sticks, here.limit, {}};
  const Vector2d travel = here.across - across_.back();
  if (slips) point.step = elements::slip(k, before.force, travel, before.limit.value, here.limit.value);
  else {
    point.step.force = before.force + k * travel;
    point.step.by_start.setIdentity();
    point.step.by_travel = k * Matrix2d::Identity();
  }
  point.force = point.step.force;
  points_.push_back(point);
  across_.push_back(here.across);
}

Matrix2d RubbingLoop::kept() const {
  Matrix2d all = Matrix2d::Identity();
  for (std::size_t i = 1; i < points_.size(); ++i) all = (points_[i].step.by_start * all).eval();
  return all;
}

std::size_t RubbingLoop::point_after(double& phase) const {
  while (phase < points_.front().phase) phase += two_pi;
  while (phase >= points_.back().phase) phase -= two_pi;
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, phase,
                                      [](double value, const Point& point) { return value < point.phase; });
  return static_cast<std::size_t>(after - points_.begin());
}

Vector2d RubbingLoop::force(double phase) const {
  if (points_.empty()) return Vector2d::Zero();
  const std::size_t after = point_after(phase);
  const Here here = at(phase);
  const double k = law_.law().stiffness;
  if (always_sticks_) return k * (here.across - place_.place);
  const Point& before = points_[after - 1];
  const Vector2d travel = here.across - across_[after - 1];
  switch (points_[after].state) {
    case State::open:
      return Vector2d::Zero();
    case State::sticks:
      return before.force + k * travel;
    case State::slips:
      return elements::slip(k, before.force, travel, before.limit.value, here.limit.value).force;
  }
  return Vector2d::Zero();
}

RubbingLoop::Moment RubbingLoop::moment(double phase) const {
  const std::size_t after = point_after(phase);
  Moment found{points_[after].state};
  const Here here = at(phase);
  found.limit = here.limit;
  if (found.state != State::slips) return found;
  const Point& before = points_[after - 1];
  const double k = law_.law().stiffness;
  const Vector2d travel = here.across - across_[after - 1],
                 force = elements::slip(k, before.force, travel, before.limit.value, here.limit.value).force;
  if (const double size = force.norm(); size > 0) {
    found.direction = force / size;
    found.fading = (k * here.across_slope.dot(found.direction) - here.limit_slope) / size;
    found.turning =
        k / size * (found.direction.x() * here.across_slope.y() - found.direction.y() * here.across_slope.x());
  }
  return found;
}

std::vector<RubbingLoop::Change> RubbingLoop::changes() const {
  std::vector<Change> found;
  if (always_sticks_) return found;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Point &here = points_[i], &next = i + 1 < points_.size() ? points_[i + 1] : points_[1];
    if (here.state == next.state) continue;
    const double size = here.force.norm();
    found.push_back({std::fmod(here.phase, two_pi), here.state, next.state, here.limit,
                     size > 0 ? Vector2d(here.force / size) : Vector2d::Zero()});
  }
  return found;
}

template <typename Scalar>
RubbingLoop::Forces<Scalar> RubbingLoop::variation(Of of,
                                                   const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& by,
                                                   std::optional<Scalar> turned) const {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Forces<Scalar> found = {Matrix::Zero(by.rows(), by.cols()), Matrix::Zero(by.rows(), by.cols())};
  if (points_.empty()) return found;
  if (always_sticks_) {
    if (of != Of::limit) found[of == Of::first_across ? 0 : 1] = law_.law().stiffness * by;
    if (turned) return found;
    for (const DeepestPlace::Held& held : place_.held)
      for (Index a = 0; a < 2; ++a) {
        const double moves = of == Of::limit ? held.by_radius(a)
                                             : law_.law().stiffness * held.by_center(a, of == Of::first_across ? 0 : 1);
        found[to_size(a)].rowwise() -= (moves * by.row(to_index(held.disc))).eval();
      }
    return found;
  }
  std::vector<Matrix2d> kept = {Matrix2d::Identity()};
  for (Index i = 1; i < by.rows(); ++i) {
    const Point& point = points_[to_size(i)];
    const elements::Slip& step = point.step;
    kept.push_back(step.by_start * kept.back());
    for (Index a = 0; a < 2; ++a) {
      auto row = found[to_size(a)].row(i);
      row = step.by_start(a, 0) * found[0].row(i - 1) + step.by_start(a, 1) * found[1].row(i - 1);
      if (of == Of::limit) row += step.by_limit(a) * by.row(i) + step.by_limit_before(a) * by.row(i - 1);
      else row += step.by_travel(a, of == Of::first_across ? 0 : 1) * (by.row(i) - by.row(i - 1));
    }
  }
  if (opens_) return found;
  using Square = Eigen::Matrix<Scalar, 2, 2>;
  const Square left = turned.value_or(1) * Square::Identity() - kept.back().template cast<Scalar>();
  const Scalar determinant = left(0, 0) * left(1, 1) - left(0, 1) * left(1, 0);
  const Index last = by.rows() - 1;
  const Eigen::Matrix<Scalar, 1, Eigen::Dynamic> first = found[0].row(last), second = found[1].row(last);
  const Eigen::Matrix<Scalar, 1, Eigen::Dynamic> start_first = (left(1, 1) * first - left(0, 1) * second) / determinant,
                                                 start_second =
                                                     (left(0, 0) * second - left(1, 0) * first) / determinant;
  for (Index i = 0; i < by.rows(); ++i)
    for (Index a = 0; a < 2; ++a)
      found[to_size(a)].row(i) += kept[to_size(i)](a, 0) * start_first + kept[to_size(i)](a, 1) * start_second;
  return found;
}

template RubbingLoop::Forces<double> RubbingLoop::variation(Of, const Eigen::MatrixXd&, std::optional<double>) const;
template RubbingLoop::Forces<std::complex<double>> RubbingLoop::variation(Of, const Eigen::MatrixXcd&,
                                                                          std::optional<std::complex<double>>) const;

}  // namespace trivet::nonlinear
