// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_over_period.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace trivet::nonlinear {

using Eigen::VectorXd;

LawOverPeriod::LawOverPeriod(const DeviationLaw& law, const Eigen::VectorXd& deflection, Eigen::Index harmonics,
                             double omega, const Eigen::Ref<const Eigen::MatrixXd>& samples, double round_off)
    : law_(law), omega_(omega), deflection_(deflection), rate_(omega * numerics::phase_derivative(deflection)) {
  assert(deflection.tail(deflection.size() - numerics::coefficient_count(harmonics)).isZero(0));
  if (!law.of_amplitude().empty()) {
    ahead_ = numerics::phase_derivative(deflection_);
    for (Eigen::Index k = 1; 2 * k < ahead_.size(); ++k) ahead_.segment<2>(2 * k - 1) /= static_cast<double>(k);
    for (const elements::PayneForce& one : law.of_amplitude()) {
      const elements::StiffnessOfAmplitude there = elements::stiffness_at(one, amplitude());
      of_amplitude_.storage += there.storage;
      of_amplitude_.loss += there.loss;
      of_amplitude_.storage_slope += there.storage_slope;
      of_amplitude_.loss_slope += there.loss_slope;
    }
  }
  const auto crossings = [&](const VectorXd& course, const std::vector<double>& levels) {
    return numerics::level_crossings(course.head(numerics::coefficient_count(harmonics)), levels, samples);
  };
  if (!law.kinks().empty()) corners_ = crossings(deflection_, law.kinks());
  if (!law.rate_kinks().empty()) {
    const std::vector<double> of_rate = crossings(rate_, law.rate_kinks());
    corners_.insert(corners_.end(), of_rate.begin(), of_rate.end());
    std::ranges::sort(corners_);
  }
  if (law.hysteretic().empty() && law.bristles().empty()) return;
  const auto turns = [&](double turning_slope) -> std::vector<double> {
    if (amplitude() <= round_off) return {};
    const VectorXd slope = numerics::phase_derivative(deflection_), bend = numerics::phase_derivative(slope);
    if (turning_slope == 0) return crossings(slope, {0});
    std::vector<double> found;
    double before = 0;
    for (const double phase : crossings(slope, {-turning_slope, turning_slope})) {
      const auto at = [&](const VectorXd& one) { return numerics::motion_at((one.size() - 1) / 2, phase, one); };
      const double sense = at(slope) > 0 ? 1 : -1;
      if (sense * at(bend) > 0 || sense == before) continue;
      found.push_back(phase);
      before = sense;
    }
    if (found.size() % 2 == 1) found.pop_back();  // the first and the last are one turning point
    return found;
  };
  assert(std::ranges::is_sorted(corners_));
  const double turning_slope = this->turning_slope(harmonics);
  for (const DeviationLaw::Hysteretic& part : law.hysteretic()) {
    const double of_part = elements::jumps_at_turns(part.law) ? turning_slope : 0;
    if (HystereticLoop loop(part, deflection_, turns(of_part), of_part); !loop.branches().empty())
      loops_.push_back(std::move(loop));
    else resting_stiffness_ += elements::initial_stiffness(part.law);
  }
  if (law.bristles().empty()) return;
  constexpr double per_wave = 4;  // panels per wave of the highest harmonic
  const Eigen::Index harmonics_kept = (deflection_.size() - 1) / 2;
  const double highest = std::max(2.0, static_cast<double>(harmonics_kept));
  const std::vector<double> of_bristles = turns(0);
  for (const DeviationLaw::Bristles& part : law.bristles())
    bristles_.emplace_back(part, deflection_, omega, of_bristles, foundation::two_pi / (per_wave * highest));
}

/// Friction without a spring jumps where the deflection turns, which bends its slope there by J/(m ω²): the harmonics
/// beyond H, Σ 1/(π k²) of that, are missing in the slope of the first H, which is this one where the whole is zero.
double LawOverPeriod::turning_slope(Eigen::Index harmonics) const {
  double slip = 0;
  for (const DeviationLaw::Hysteretic& part : law_.hysteretic())
    if (const auto* friction = std::get_if<elements::CoulombFriction>(&part.law)) slip += friction->slip;
  if (slip == 0 || !(omega_ > 0)) return 0;
  double missing = foundation::two_pi * foundation::two_pi / 24;  // Σ 1/k², k = 1 …
  for (Eigen::Index k = 1; k <= harmonics; ++k) missing -= 1 / static_cast<double>(k * k);
  return 2 * slip * law_.acceleration_per_force() / (omega_ * omega_) * missing / (foundation::two_pi / 2);
}

std::vector<double> LawOverPeriod::all_corners() const {
  std::vector<double> all = corners_;
  for (const HystereticLoop& loop : loops_)
    for (const HystereticLoop::Branch& branch : loop.branches()) {
      all.push_back(branch.from);
      if (branch.kink) all.push_back(std::fmod(*branch.kink, foundation::two_pi));
    }
  for (const BristleLoop& loop : bristles_) {
    const std::vector<double> of_loop = loop.corners();
    all.insert(all.end(), of_loop.begin(), of_loop.end());
  }
  return all;
}

double LawOverPeriod::deflection_at(double phase) const {
  return numerics::motion_at((deflection_.size() - 1) / 2, phase, deflection_);
}

double LawOverPeriod::rate_at(double phase) const { return numerics::motion_at((rate_.size() - 1) / 2, phase, rate_); }

double LawOverPeriod::amplitude() const { return deflection_.tail(deflection_.size() - 1).norm(); }

DeviationLaw::Force LawOverPeriod::at(double phase) const {
  return at(numerics::fourier_row((deflection_.size() - 1) / 2, phase));
}

VectorXd LawOverPeriod::elastic_tangents(const Eigen::MatrixXd& rows) const {
  return law_.elastic_tangents(rows * deflection_).array() + resting_stiffness_;
}

DeviationLaw::Force LawOverPeriod::at(const Eigen::RowVectorXd& row) const {
  const double deflection = deflection_at(row);
  DeviationLaw::Force found = law_.without_memory(deflection, is_damped() ? rate_at(row) : 0);
  found.force += resting_stiffness_ * deflection;
  found.by_deviation += resting_stiffness_;
  if (law_.of_amplitude().empty()) return found;
  found.force += of_amplitude_.storage * deflection + of_amplitude_.loss * row.dot(ahead_);
  found.by_deviation += of_amplitude_.storage;
  if (omega_ > 0) found.by_rate += of_amplitude_.loss / omega_;
  return found;
}

}  // namespace trivet::nonlinear
