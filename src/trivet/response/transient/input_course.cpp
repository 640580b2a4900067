// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/input_course.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

/// A polygon of fewer lines counts as a designed pulse, not as a measurement.
constexpr std::ptrdiff_t fewest_samples = 4;
/// Jumps below this share of the largest value are round-off between pieces.
constexpr double jump_round_off = 1e-9;

/// Steps of samples that differ less are equal: a clock, written with few digits.
constexpr double equal_steps = 1e-6;

/// Largest magnitudes of u, u̇ and ü.
struct Largest {
  double value = 0, rate = 0, curvature = 0;
  void add(double u, double du, double ddu) {
    value = std::max(value, std::abs(u));
    rate = std::max(rate, std::abs(du));
    curvature = std::max(curvature, std::abs(ddu));
  }
  /// Bounds within u = value + rate sin κs/κ + curvature (1 − cos κs)/κ²: a half sine is 0 at both of its ends.
  void add_sine(const excitation::Piece& p) {
    add(std::abs(p.value) + std::abs(p.rate) / p.kappa + 2 * std::abs(p.curvature) / (p.kappa * p.kappa),
        std::abs(p.rate) + std::abs(p.curvature) / p.kappa, std::abs(p.curvature) + p.kappa * std::abs(p.rate));
  }
};

}  // namespace

InputCourse::InputCourse(const excitation::Signal& signal, double delay, Integrals integrals)
    : pieces_(&signal.pieces), delay_(delay) {
  examine_pieces();
  if (integrals == Integrals::not_needed) return;
  excitation::SignalIntegrals sum;
  for (Place i = 0; i < count(); ++i) {
    before_.push_back(sum);
    if (i + 1 == count()) break;
    const double s = start_of(i + 1) - start_of(i);
    const excitation::SignalIntegrals more = excitation::integrals_on(piece(i), s);
    sum.twice += sum.once * s + more.twice;
    sum.once += more.once;
  }
}

InputVector InputCourse::with_integrals(Place place, double t) const {
  InputVector w = InputVector::Zero();
  if (place < 0) return w;
  const excitation::Piece& p = piece(place);
  const double s = t - start_of(place);
  const excitation::SignalState u = excitation::state_on(p, s);
  w.tail<3>() << u.value, u.rate, u.curvature;
  if (before_.empty()) return w;
  const excitation::SignalIntegrals own = excitation::integrals_on(p, s), &before = before_[place];
  w(0) = before.twice + before.once * s + own.twice;
  w(1) = before.once + own.once;
  return w;
}

/// One scan for all, since a record may have millions of pieces.
void InputCourse::examine_pieces() {
  Largest size, jump;
  excitation::SignalState before;
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (Place i = 0; i < count(); ++i) {
    const excitation::Piece& p = piece(i);
    if (kappas_.size() != 1 || p.kappa != kappas_.front()) add_kappa(i, p.kappa);
    size.add(p.value, p.rate, p.curvature);
    if (p.kappa > 0) size.add_sine(p);
    jump.add(p.value - before.value, p.rate - before.rate, p.curvature - before.curvature);
    if (i + 1 == count()) break;
    const double step = piece(i + 1).start - p.start;
    assert(step >= 0 && "valid signals have ascending pieces");
    shortest = std::min(shortest, step);
    longest = std::max(longest, step);
    before = excitation::state_on(p, step);
    size.add(before.value, before.rate, before.curvature);
  }
  least_jump_ = {jump_round_off * size.value, jump_round_off * size.rate, jump_round_off * size.curvature};
  smoothness_ = jump.value > least_jump_[0] ? 0 : jump.rate > least_jump_[1] ? 1 : 2;
  if (kappas_.empty()) kappas_.push_back(0);
  polygon_ = size.curvature == 0 && kappas_ == std::vector<double>{0};
  const bool sampled = polygon_ && count() > fewest_samples;
  if (sampled) sampling_step_ = longest - shortest <= equal_steps * longest ? shortest : median_step();
}

void InputCourse::add_kappa(Place place, double kappa) {
  auto known = std::ranges::find(kappas_, kappa);
  if (known == kappas_.end()) {
    known = kappas_.insert(known, kappa);
    if (kappas_.size() == 2) kappa_index_.assign(to_size(place), 0);
  }
  if (kappas_.size() > 1) kappa_index_.push_back(to_size(known - kappas_.begin()));
}

double InputCourse::median_step() const {
  std::vector<double> steps;
  for (Place i = 0; i + 1 < count(); ++i) steps.push_back(piece(i + 1).start - piece(i).start);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

InputCourse::Place InputCourse::place_at(double t, double resolution) const {
  const auto after =
      std::upper_bound(pieces_->begin(), pieces_->end(), t + resolution,
                       [&](double time, const excitation::Piece& each) { return time < each.start + delay_; });
  return after - pieces_->begin() - 1;
}

InputVector InputCourse::jump_into(Place place) const {
  InputVector jump = InputVector::Zero();
  assert(place >= 0 && place < count());
  const excitation::Piece& p = piece(place);
  jump.tail<3>() << p.value, p.rate, p.curvature;
  if (place > 0) {
    const excitation::SignalState before =
        excitation::state_on(piece(place - 1), start_of(place) - start_of(place - 1));
    jump.tail<3>() -= Eigen::Vector3d(before.value, before.rate, before.curvature);
  }
  return jump;
}

double largest_kappa(const std::vector<InputCourse>& courses) {
  double largest = 0;
  for (const InputCourse& course : courses)
    for (const double kappa : course.kappas()) largest = std::max(largest, kappa);
  return largest;
}

}  // namespace trivet::response
