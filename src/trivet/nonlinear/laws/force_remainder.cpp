// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using foundation::two_pi;

ForceRemainder::ForceRemainder(const LawSet& laws, const MatrixXd& course, const MatrixXd& harmonics, double omega)
    : course_(course), harmonics_(harmonics), omega_(omega), known_(to_size(course.cols()), false) {
  std::vector<double> corners;
  assert(course.cols() == to_index(laws.single().size()) && harmonics.cols() == course.cols());
  for (Index j = 0; j < course.cols(); ++j) {
    const LawHarmonics& law = laws.single()[j];
    if (law.law().is_empty()) continue;
    LawOverPeriod along = laws.course(j, course, omega);
    // Bristles that rest are springs, and have the harmonics of the motion.
    if (std::ranges::any_of(along.bristles(), [](const BristleLoop& loop) { return !loop.moves(); })) continue;
    known_[j] = true;
    const std::vector<double> own = along.all_corners();
    corners.insert(corners.end(), own.begin(), own.end());
    singles_.push_back({j, std::move(along)});
  }
  for (const LawSet::Distance& one : laws.distances()) {
    distances_.push_back(&one);
    for (Index a = 0; a < 3; ++a) known_[one.first + a] = true;
    const std::vector<double> own = one.law.corners(course.middleCols(one.first, 3));
    corners.insert(corners.end(), own.begin(), own.end());
  }
  for (const LawSet::Rubbing& one : laws.rubbings()) {
    rubbings_.push_back({one.on, laws.loop(one, course, omega)});
    known_[one.on[1]] = known_[one.on[2]] = true;
    for (const RubbingLoop::Change& change : rubbings_.back().loop.changes()) corners.push_back(change.phase);
  }
  add_phases(std::move(corners));
}

void ForceRemainder::add_phases(std::vector<double> corners) {
  constexpr int per_harmonic = 8, between_corners = 12;
  constexpr double beside = 1e-9;
  const auto harmonics = static_cast<int>((course_.rows() - 1) / 2), even = per_harmonic * (harmonics + 1);
  for (int n = 0; n < even; ++n) phases_.push_back(two_pi * n / even);
  std::ranges::sort(corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double from = corners[i], to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + two_pi;
    if (to - from < 4 * beside) continue;
    phases_.push_back(from + beside);
    phases_.push_back(to - beside);
    for (int n = 1; n < between_corners; ++n) phases_.push_back(from + (to - from) * n / between_corners);
  }
  for (double& phase : phases_) phase = std::fmod(phase, two_pi);
  std::ranges::sort(phases_);
}

Eigen::RowVectorXd ForceRemainder::at(double phase) const {
  const Eigen::RowVectorXd row = numerics::fourier_row((course_.rows() - 1) / 2, phase);
  const Eigen::RowVectorXd deflections = row * course_;
  Eigen::RowVectorXd found = Eigen::RowVectorXd::Zero(course_.cols());
  for (const Single& one : singles_) {
    found(one.deflection) += one.course.at(row).force;
    for (const HystereticLoop& loop : one.course.loops())
      found(one.deflection) += loop.at(loop.branch_at(phase), deflections(one.deflection)).force;
    for (const BristleLoop& loop : one.course.bristles()) found(one.deflection) += loop.at(phase).force;
  }
  for (const LawSet::Distance* one : distances_)
    found.segment<3>(one->first) +=
        one->law.at_phase(course_.middleCols(one->first, 3), omega_, phase).force.transpose();
  for (const Rubbing& one : rubbings_)
    found(one.on) += one.loop.force(phase).transpose() - deflections(one.on) * one.loop.law().own_stiffness();
  const Eigen::RowVectorXd smooth = row * harmonics_;
  for (Index j = 0; j < found.size(); ++j) found(j) = known_[j] ? found(j) - smooth(j) : 0;
  return found;
}

}  // namespace trivet::nonlinear
