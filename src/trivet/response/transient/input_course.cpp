// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/input_course.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

/// A polygon of fewer lines counts as a designed pulse, not as a measurement.
constexpr std::size_t fewest_samples = 4;
/// Jumps below this share of the largest value are round-off between pieces.
constexpr double jump_round_off = 1e-9;

double usual_step(const std::vector<excitation::Piece>& pieces) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    if (pieces[i].kappa != 0 || pieces[i].curvature != 0) return 0;
    steps.push_back(pieces[i + 1].start - pieces[i].start);
  }
  if (steps.size() < fewest_samples) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

InputCourse::InputCourse(const excitation::Signal& signal, double delay)
    : pieces_(signal.pieces), sampling_step_(usual_step(signal.pieces)) {
  for (const excitation::Piece& each : pieces_) {
    starts_.push_back(each.start + delay);
    auto known = std::find(kappas_.begin(), kappas_.end(), each.kappa);
    if (known == kappas_.end()) known = kappas_.insert(known, each.kappa);
    kappa_index_.push_back(to_size(known - kappas_.begin()));
  }
  if (kappas_.empty()) kappas_.push_back(0);
  excitation::SignalIntegrals sum;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    before_.push_back(sum);
    if (i + 1 == pieces_.size()) break;
    const double s = starts_[i + 1] - starts_[i];
    const excitation::SignalIntegrals more = excitation::integrals_on(pieces_[i], s);
    sum.twice += sum.once * s + more.twice;
    sum.once += more.once;
  }
  Eigen::Array3d largest = Eigen::Array3d::Zero();
  for (const excitation::Piece& each : pieces_)
    largest = largest.max(Eigen::Array3d(each.value, each.rate, each.curvature).abs());
  for (Place i = 0; i < count(); ++i) {
    const Eigen::Array3d jump = jump_into(i).tail<3>().array().abs();
    unsigned char bits = 0;
    for (int m = 0; m < 3; ++m)
      if (jump(m) > jump_round_off * largest(m))
        bits |= static_cast<unsigned char>(1u << m), smoothness_ = std::min(smoothness_, m);
    jumps_.push_back(bits);
  }
}

InputVector InputCourse::at(Place place, double t) const {
  InputVector w = InputVector::Zero();
  if (place < 0) return w;
  const auto i = to_size(place);
  const excitation::Piece& p = pieces_[i];
  const double s = t - starts_[i];
  const excitation::SignalState u = excitation::state_on(p, s);
  const excitation::SignalIntegrals own = excitation::integrals_on(p, s);
  w << before_[i].twice + before_[i].once * s + own.twice, before_[i].once + own.once, u.value, u.rate, u.curvature;
  return w;
}

InputCourse::Place InputCourse::place_at(double t, double resolution) const {
  return std::upper_bound(starts_.begin(), starts_.end(), t + resolution) - starts_.begin() - 1;
}

InputVector InputCourse::jump_into(Place place) const {
  InputVector jump = InputVector::Zero();
  const auto i = to_size(place);
  const excitation::Piece& p = pieces_[i];
  jump.tail<3>() << p.value, p.rate, p.curvature;
  if (place > 0) {
    const excitation::SignalState before = excitation::state_on(pieces_[i - 1], starts_[i] - starts_[i - 1]);
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
