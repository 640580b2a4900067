// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/law_course.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace trivet::nonlinear {

LawCourse::LawCourse(const LawAbout& law, const Eigen::VectorXd& deflection, double omega,
                     const Eigen::Ref<const Eigen::MatrixXd>& samples)
    : law_(law), deflection_(deflection), rate_(omega * numerics::phase_derivative(deflection)) {
  if (!law.kinks().empty()) corners_ = numerics::level_crossings(deflection_, law.kinks(), samples);
  if (!law.rate_kinks().empty()) {
    const std::vector<double> of_rate = numerics::level_crossings(rate_, law.rate_kinks(), samples);
    corners_.insert(corners_.end(), of_rate.begin(), of_rate.end());
    std::sort(corners_.begin(), corners_.end());
  }
  if (law.hysteretic().empty()) return;
  const std::vector<double> turns = numerics::level_crossings(numerics::phase_derivative(deflection_), {0}, samples);
  for (const LawAbout::Hysteretic& part : law.hysteretic())
    if (HystereticLoop loop(part, deflection_, turns); !loop.branches().empty()) loops_.push_back(std::move(loop));
}

std::vector<double> LawCourse::all_corners() const {
  std::vector<double> all = corners_;
  for (const HystereticLoop& loop : loops_)
    for (const HystereticLoop::Branch& branch : loop.branches()) {
      all.push_back(branch.from);
      if (branch.kink) all.push_back(std::fmod(*branch.kink, foundation::two_pi));
    }
  return all;
}

double LawCourse::deflection_at(double phase) const {
  return numerics::motion_at((deflection_.size() - 1) / 2, phase, deflection_);
}

double LawCourse::rate_at(double phase) const { return numerics::motion_at((rate_.size() - 1) / 2, phase, rate_); }

LawAbout::Force LawCourse::at(double phase) const {
  return law_.without_memory(deflection_at(phase), is_damped() ? rate_at(phase) : 0);
}

}  // namespace trivet::nonlinear
