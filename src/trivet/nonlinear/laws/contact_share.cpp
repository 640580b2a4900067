// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/contact_share.h"

#include <cassert>
#include <utility>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {
namespace {

using foundation::two_pi;

/// The share of a period in which something holds that changes at corners only.
template <typename Holds>
double share_of_period(const std::vector<double>& corners, const Holds& holds) {
  if (corners.empty()) return holds(0.0) ? 1 : 0;
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + two_pi;
    if (holds((corners[i] + to) / 2)) sum += to - corners[i];
  }
  assert(sum <= two_pi * (1 + 1e-12) && "stretches between corners add up to a period");
  return sum / two_pi;
}

}  // namespace

double contact_share(const LawHarmonics& law, const Eigen::VectorXd& deflection, double omega) {
  const std::pair<double, double> untouched = law.law().untouched();
  const LawOverPeriod course = law.course(deflection, omega);
  return share_of_period(course.corners(), [&](double phase) {
    const double here = course.deflection_at(phase);
    return here < untouched.first || here > untouched.second;
  });
}

double contact_share(const DistanceHarmonics& law, const Eigen::MatrixXd& course) {
  const Eigen::Index harmonics = (course.rows() - 1) / 2;
  return share_of_period(law.corners(course), [&](double phase) {
    const Eigen::Vector3d here = (numerics::fourier_row(harmonics, phase) * course).transpose();
    return law.law().distance(here) > law.law().kinks().front();
  });
}

}  // namespace trivet::nonlinear
