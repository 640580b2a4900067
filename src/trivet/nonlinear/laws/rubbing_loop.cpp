// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/rubbing_loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
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

RubbingLoop::RubbingLoop(const ContactFriction& law, const MatrixXd& course, const std::vector<double>& corners,
                         double omega, double longest, bool rough)
    : law_(law), motion_(course), omega_(omega), parts_(rough ? 1 : 2) {
  assert(course.cols() == 3 && std::ranges::is_sorted(corners));
  assert(corners.empty() || (corners.front() >= 0 && corners.back() <= two_pi));
  std::vector<double> ends = corners;
  if (ends.empty()) ends = {0};
  if (law_.is_ring()) ends = with_losses_of_pressure(ends);
  const auto is_open = [&](std::size_t i) {
    const double to = i + 1 < ends.size() ? ends[i + 1] : ends.front() + two_pi;
    return at((ends[i] + to) / 2).limit.value == 0;
  };
  // From the start of an open stretch, at the end of which there is no force.
  std::size_t first = 0;
  while (first < ends.size() && !is_open(first)) ++first;
  opens_ = first < ends.size();
  if (opens_ && ends.size() < 2) return;
  if (opens_) {
    std::rotate(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(first), ends.end());
    for (double& end : ends)
      if (end < ends.front()) end += two_pi;
  }
  longest = 2 * std::min(longest, step_of_stiffness(ends));
  const double start = ends.front();
  ends.erase(ends.begin());
  ends.push_back(start + two_pi);
  assert(std::ranges::is_sorted(ends) && !(ends.front() < start) && "stretches follow each other for a period");
  if (opens_) {
    begin(start, Vector2d::Zero());
    march(ends, longest);
  } else if (!settles(start, ends, longest)) {
    close(start, ends, longest);
  }
}

/// With the instants at which the damping of a ring takes all its pressure, and gives it back. (Those of stops along an
/// axis are among their corners.)
std::vector<double> RubbingLoop::with_losses_of_pressure(const std::vector<double>& ends) const {
  constexpr int samples = 64, halvings = 50;
  const auto is_pressed = [&](double phase) { return at(phase).limit.value > 0; };
  std::vector<double> found = ends;
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const double from = ends[e], length = (e + 1 < ends.size() ? ends[e + 1] : ends.front() + two_pi) - from;
    const auto place = [&](int n) { return from + length * (n + 0.5) / samples; };
    for (int n = 0; n + 1 < samples; ++n) {
      double low = place(n), high = place(n + 1);
      const bool before = is_pressed(low);
      if (is_pressed(high) == before) continue;
      for (int i = 0; i < halvings; ++i)
        if (const double middle = (low + high) / 2; is_pressed(middle) == before) low = middle;
        else high = middle;
      found.push_back(std::fmod(high, two_pi));
    }
  }
  std::ranges::sort(found);
  return found;
}

/// Under slip the force follows the travel within a travel of L/k: from node to node at most a quarter of that at the
/// largest limit, if this needs no more than eight times the usual nodes. Where the friction keeps its line nothing
/// turns: in a plane on a straight way, within a ring around it or along its axis.
double RubbingLoop::step_of_stiffness(const std::vector<double>& ends) const {
  constexpr int samples = 32, nodes = 8, most = 512;
  double largest = 0;
  Vector2d fastest = Vector2d::Zero();
  std::vector<Vector2d> speeds;
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const double length = (e + 1 < ends.size() ? ends[e + 1] : ends.front() + two_pi) - ends[e];
    if (at(ends[e] + length / 2).limit.value == 0) continue;
    for (int n = 0; n < samples; ++n) {
      const Here here = at(ends[e] + length * (n + 0.5) / samples);
      largest = std::max(largest, here.limit.value);
      speeds.push_back(here.rates.across);
      if (speeds.back().squaredNorm() > fastest.squaredNorm()) fastest = speeds.back();
    }
  }
  if (fastest.norm() == 0) return two_pi;
  constexpr double straight = 1e-9;
  const auto is_along = [&](const Vector2d& line) {
    const Vector2d aside = Vector2d(-line.y(), line.x()) / fastest.norm();
    return std::ranges::all_of(speeds, [&](const Vector2d& speed) { return std::abs(aside.dot(speed)) < straight; });
  };
  if (law_.is_ring() ? is_along(Vector2d::UnitX()) || is_along(Vector2d::UnitY()) : is_along(fastest.normalized()))
    return two_pi;
  return std::max(two_pi / most, nodes * largest / (law_.law().stiffness * fastest.norm()) / 4);
}

RubbingLoop::Here RubbingLoop::at(double phase) const {
  // L' = ∂L/∂a a' + ∂L/∂ȧ ω a'', with a' = n δ' and a'' = n' δ' + n δ'' of the deviation a along the contact.
  const auto [value, slope, bend] = motion_.at(phase);
  Here found{law_.frame(value), {}, {}, 0};
  found.rates = rates_of(found.frame, slope);
  found.limit = law_.limit(found.frame.along, omega_ * found.rates.along);
  const double bends = found.rates.normal.dot(slope) + found.frame.normal.dot(bend);
  found.limit_slope = found.limit.by_deflection * found.rates.along + found.limit.by_rate * omega_ * bends;
  return found;
}

/// By the phase, of the friction while the contact sticks.
Vector2d RubbingLoop::pull(const Here& here, const Vector2d& friction) const {
  // f = H f_t and f_t' = k s': f' = k H s' + H' f_t, and the hoop ρ₀/ρ falls by curvature · ρ' of itself.
  Vector2d found = law_.law().stiffness * here.frame.friction(here.rates.across);
  found.x() -= here.frame.curvature * here.rates.along * friction.x();
  return found;
}

/// With the mean of both hoops, so that the errors are of second order, and at the end on the limit of the last one.
RubbingLoop::Step RubbingLoop::slip(const Point& from, const Here& to) const {
  const double k = law_.law().stiffness, limit = to.limit.value;
  assert(!(limit < 0) && !(from.limit.value < 0) && "a contact that slips is closed, or just opens");
  const Vector2d travelled = travel(from, to);
  if (!law_.is_ring()) return {elements::slip(k, from.force, travelled, from.limit.value, limit)};
  Step found{
      elements::slip_on_wall(k, from.force, travelled, from.limit.value, limit, (from.frame.hoop + to.frame.hoop) / 2)};
  const Vector2d force = found.force, friction = to.frame.friction(force);
  const double size = friction.norm();
  if (size == 0) return found;
  const double scaled = limit / size;
  const Matrix2d by_force =
      scaled * (Matrix2d::Identity() - force * to.frame.friction(friction).transpose() / (size * size));
  found.force = scaled * force;
  assert(!(std::abs(to.frame.friction(found.force).norm() - limit) > 1e-9 * limit) && "it slips on its limit");
  found.by_start = (by_force * found.by_start).eval();
  found.by_travel = (by_force * found.by_travel).eval();
  found.by_limit = (by_force * found.by_limit + force / size).eval();
  found.by_limit_before = (by_force * found.by_limit_before).eval();
  found.by_hoop_before = by_force * found.by_hoop / 2;
  found.by_hoop = found.by_hoop_before - scaled * friction.x() * force.x() / (size * size) * force;
  return found;
}

/// Does it stick all the time, with the springs at the place where their forces stay farthest below their limits?
bool RubbingLoop::settles(double start, const std::vector<double>& ends, double longest) {
  begin(start, Vector2d::Zero());
  double from = start;
  for (const double to : ends) {
    if (to - from > round_off) append_nodes(from, to, longest / parts_, false);
    from = to;
  }
  if (goes_round()) {
    place_ = {points_.front().frame.across, 0, {}};
    return false;
  }
  const double k = law_.law().stiffness;
  std::vector<Disc> discs;
  for (const Point& point : points_) discs.push_back({point.frame.across, point.limit.value / k, point.frame.hoop});
  place_ = deepest_place(discs);
  always_sticks_ = place_.beyond <= 0;
  for (Point& point : points_) point.force = k * (point.frame.across - place_.place);
  return always_sticks_;
}

bool RubbingLoop::goes_round() const {
  const Vector2d &start = points_.front().frame.across, &end = points_.back().frame.across;
  return (end - start - law_.travel(start, end)).norm() > 0;
}

/// By Newton's method on the force at the start.
void RubbingLoop::close(double start, const std::vector<double>& ends, double longest) {
  const Here here = at(start);
  Vector2d force = law_.law().stiffness * (here.frame.across - place_.place);
  const auto within_limit = [&] {
    if (const double size = here.frame.friction(force).norm(); size > here.limit.value)
      force *= here.limit.value / size;
  };
  within_limit();
  // f(2π; f₀) = f₀: Newton's step is (1 − ∂f(2π)/∂f₀)⁻¹ (f(2π) − f₀), the derivative being the product of all steps.
  constexpr int most = 60;
  for (int i = 0; i < most; ++i) {
    begin(start, force);
    march(ends, longest);
    const Vector2d missing = points_.back().force - force;
    double largest = 0, farthest = 0;
    for (const Point& point : points_) {
      largest = std::max(largest, point.limit.value);
      farthest = std::max(farthest, point.frame.across.norm());
    }
    // Travels have the round-off of the places on the wall.
    constexpr double of_places = 1e-15;
    if (missing.norm() <= round_off * largest + of_places * law_.law().stiffness * farthest) {
      always_sticks_ = std::all_of(points_.begin() + 1, points_.end(),
                                   [](const Point& point) { return point.state == State::sticks; });
      if (always_sticks_) place_ = {here.frame.across - force / law_.law().stiffness, 0, {}};
      return;
    }
    const Matrix2d left = Matrix2d::Identity() - kept();
    constexpr double singular = 1e-12;
    const double determinant = left(0, 0) * left(1, 1) - left(0, 1) * left(1, 0);
    Matrix2d inverse;
    inverse << left(1, 1), -left(0, 1), -left(1, 0), left(0, 0);
    if (std::abs(determinant) > singular) force += inverse * missing / determinant;
    else force = points_.back().force;
    within_limit();
  }
  // Not closed: no motion is found with it.
  for (Point& point : points_) point.force.setConstant(std::numeric_limits<double>::quiet_NaN());
}

void RubbingLoop::begin(double start, const Vector2d& force) {
  points_.clear();
  const Here here = at(start);
  points_.push_back(
      {.phase = start, .force = force, .limit = here.limit, .frame = here.frame, .normal_slope = here.rates.normal});
}

void RubbingLoop::march(const std::vector<double>& ends, double longest) {
  double from = ends.back() - two_pi;
  for (const double to : ends) {
    if (to - from > round_off) {
      if (at((from + to) / 2).limit.value > 0) {
        rub(from, to, longest);
      } else {
        points_.push_back({.phase = to, .frame = at(to).frame});
      }
    }
    from = to;
  }
}

void RubbingLoop::rub(double from, double to, double longest) {
  bool slips = slips_from(from, to);
  const int panels = parts_ * std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
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
  const Vector2d force = points_.back().force + law_.law().stiffness * travel(points_.back(), here);
  return here.frame.friction(force).norm() > here.limit.value;
}

/// Has the state changed, from the last point to a phase?
bool RubbingLoop::has_changed(double phase, bool slips) const {
  const Here here = at(phase);
  const Point& before = points_.back();
  if (!slips) {
    const Vector2d force = before.force + law_.law().stiffness * travel(before, here);
    return here.frame.friction(force).norm() > here.limit.value * (1 + round_off);
  }
  const Vector2d there = here.frame.friction(slip(before, here).force);
  const double size = there.norm();
  if (size == 0) return false;
  const double pulling = pull(here, there).dot(there) / size;
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
  std::ranges::sort(nodes);
  for (const auto& [phase, weight] : nodes) append(phase, weight, slips);
  append(to, 0, slips);
}

void RubbingLoop::append(double phase, double weight, bool slips) {
  const Here here = at(phase);
  const double k = law_.law().stiffness;
  const Point before = points_.back();
  Point point{.phase = phase,
              .weight = weight,
              .state = slips ? State::slips : State::sticks,
              .limit = here.limit,
              .frame = here.frame,
              .normal_slope = here.rates.normal};
  const Vector2d travelled = travel(before, here);
  point.frame.across = before.frame.across + travelled;
  if (slips) {
    point.step = slip(before, here);
  } else {
    point.step.force = before.force + k * travelled;
    point.step.by_start.setIdentity();
    point.step.by_travel = k * Matrix2d::Identity();
    if (before.state == State::open && opens_) {
      // Just after it closes; at that instant itself there may be no force yet.
      constexpr double soon = 1e-6;
      const Here closed = at(before.phase + soon * (phase - before.phase));
      points_.back().limit = {0, closed.limit.by_deflection, closed.limit.by_rate};
      if (closed.limit_slope > 0) point.step.travel_by_limit = closed.rates.across / closed.limit_slope;
    }
  }
  // Sticking f_i = f_{i−1} + k Δs; slipping |H f_i| = L_i, in the direction that the travel Δs turns it to.
  [[maybe_unused]] constexpr double of_ends =
      1e-9;  // a stretch begins where the one before ends, but for round-off of a period
  assert(phase >= before.phase - of_ends && "points ascend");
  point.force = point.step.force;
  points_.push_back(point);
}

Matrix2d RubbingLoop::kept() const {
  Matrix2d all = Matrix2d::Identity();
  for (std::size_t i = 1; i < points_.size(); ++i) all = (points_[i].step.by_start * all).eval();
  return all;
}

std::size_t RubbingLoop::point_after(double& phase) const {
  assert(points_.size() > 1 && "a loop with points goes on for a period");
  while (phase < points_.front().phase) phase += two_pi;
  while (phase >= points_.back().phase) phase -= two_pi;
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, phase,
                                      [](double value, const Point& point) { return value < point.phase; });
  return static_cast<std::size_t>(after - points_.begin());
}

Eigen::Vector3d RubbingLoop::force(double phase) const {
  const Moment there = moment(phase);
  return there.frame.tangents.transpose() * there.friction;
}

RubbingLoop::Moment RubbingLoop::moment(double phase) const {
  Moment found;
  if (points_.empty()) return found;
  const std::size_t after = point_after(phase);
  const Here here = at(phase);
  const Point& before = points_[after - 1];
  found = {always_sticks_ ? State::sticks : points_[after].state, here.limit, here.frame, here.rates};
  const double k = law_.law().stiffness;
  if (found.state == State::open) return found;
  if (found.state == State::sticks) {
    const Vector2d force = before.force + k * travel(before, here);
    found.friction = here.frame.friction(force);
    return found;
  }
  found.friction = here.frame.friction(slip(before, here).force);
  const double size = found.friction.norm();
  if (size == 0) return found;
  found.direction = found.friction / size;
  const Vector2d aside(-found.direction.y(), found.direction.x()), pulls = pull(here, found.friction);
  const double widens = here.frame.curvature * here.rates.along;
  found.fading = (pulls.dot(found.direction) - here.limit_slope) / size + widens * aside.x() * aside.x();
  found.turning = pulls.dot(aside) / size + widens * aside.x() * found.direction.x();
  return found;
}

std::vector<RubbingLoop::Change> RubbingLoop::changes() const {
  std::vector<Change> found;
  if (always_sticks_) return found;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Point &here = points_[i], &next = i + 1 < points_.size() ? points_[i + 1] : points_[1];
    if (here.state == next.state) continue;
    found.push_back({std::fmod(here.phase, two_pi), here.state, next.state, here.limit, here.frame,
                     at(here.phase).rates, here.frame.friction(here.force), next.step.travel_by_limit});
  }
  return found;
}

template <typename Scalar>
RubbingLoop::Forces<Scalar> RubbingLoop::variation(const Variation<Scalar>& by, std::optional<Scalar> turned) const {
  const bool of_limit = by.limit.size() > 0, of_hoop = by.hoop.size() > 0;
  const std::array<bool, 2> of_across = {by.across[0].size() > 0, by.across[1].size() > 0};
  const auto& any = of_limit ? by.limit : of_across[0] ? by.across[0] : by.across[1];
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Forces<Scalar> found = {Matrix::Zero(any.rows(), any.cols()), Matrix::Zero(any.rows(), any.cols())};
  if (points_.empty()) return found;
  const double k = law_.law().stiffness;
  if (always_sticks_) {
    for (Index c = 0; c < 2; ++c)
      if (of_across[c]) found[c] = k * by.across[c];
    if (turned) return found;
    for (const DeepestPlace::Held& held : place_.held)
      for (Index a = 0; a < 2; ++a) {
        auto& force = found[a];
        if (of_limit) force.rowwise() -= (held.by_radius(a) * by.limit.row(to_index(held.disc))).eval();
        if (of_hoop) force.rowwise() -= (k * held.by_hoop(a) * by.hoop.row(to_index(held.disc))).eval();
        for (Index c = 0; c < 2; ++c)
          if (of_across[c])
            force.rowwise() -= (k * held.by_center(a, c) * by.across[c].row(to_index(held.disc))).eval();
      }
    return found;
  }
  // δf_i = A_i δf_{i−1} + b_i from zero; then a start δf₀ that closes: (turned − Π A_i) δf₀ = what is missing after a
  // period.
  std::vector<Matrix2d> kept = {Matrix2d::Identity()};
  for (Index i = 1; i < any.rows(); ++i) {
    const Step& step = points_[i].step;
    kept.push_back(step.by_start * kept.back());
    for (Index a = 0; a < 2; ++a) {
      auto row = found[a].row(i);
      row = step.by_start(a, 0) * found[0].row(i - 1) + step.by_start(a, 1) * found[1].row(i - 1);
      if (of_limit) row += step.by_limit(a) * by.limit.row(i) + step.by_limit_before(a) * by.limit.row(i - 1);
      for (Index c = 0; c < 2; ++c)
        if (const Matrix& across = by.across[c]; of_across[c])
          row += step.by_travel(a, c) * (across.row(i) - across.row(i - 1));
      if (of_hoop) row += step.by_hoop(a) * by.hoop.row(i) + step.by_hoop_before(a) * by.hoop.row(i - 1);
      if (const double earlier = step.travel_by_limit(a); of_limit && earlier != 0)
        row += k * earlier * by.limit.row(i - 1);
    }
  }
  if (opens_) return found;
  using Square = Eigen::Matrix<Scalar, 2, 2>;
  const Square left = turned.value_or(1) * Square::Identity() - kept.back().template cast<Scalar>();
  const Scalar determinant = left(0, 0) * left(1, 1) - left(0, 1) * left(1, 0);
  const Index last = any.rows() - 1;
  const Eigen::Matrix<Scalar, 1, Eigen::Dynamic> first = found[0].row(last), second = found[1].row(last);
  const Eigen::Matrix<Scalar, 1, Eigen::Dynamic> start_first = (left(1, 1) * first - left(0, 1) * second) / determinant,
                                                 start_second =
                                                     (left(0, 0) * second - left(1, 0) * first) / determinant;
  for (Index i = 0; i < any.rows(); ++i)
    for (Index a = 0; a < 2; ++a) found[a].row(i) += kept[i](a, 0) * start_first + kept[i](a, 1) * start_second;
  return found;
}

template RubbingLoop::Forces<double> RubbingLoop::variation(const Variation<double>&, std::optional<double>) const;
template RubbingLoop::Forces<std::complex<double>> RubbingLoop::variation(const Variation<std::complex<double>>&,
                                                                          std::optional<std::complex<double>>) const;

}  // namespace trivet::nonlinear
