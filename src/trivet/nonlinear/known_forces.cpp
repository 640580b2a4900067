// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/known_forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::two_pi;

namespace {

bool is_coulomb(const LawAbout::Hysteretic& part) {
  return std::holds_alternative<elements::CoulombFriction>(part.law);
}

}  // namespace

bool KnownForces::may_rest() const {
  return std::any_of(deflections_.begin(), deflections_.end(), [](const Deflection& one) {
    return std::any_of(one.law.hysteretic().begin(), one.law.hysteretic().end(), is_coulomb);
  });
}

std::string KnownForces::left_by(const HarmonicBalance& balance, const VectorXd& motion, double omega) const {
  const Index C = balance.coefficients();
  for (std::size_t j = 0; j < deflections_.size(); ++j) {
    const Index first = to_index(j) * C;
    if (deflections_[j].distance)
      if (std::string reason = out_of_distances(j, motion.segment(first, 3 * C).reshaped(C, 3)); !reason.empty())
        return reason;
    if (std::string reason = out_of_curve(j, motion.segment(first, C)); !reason.empty()) return reason;
    if (std::string reason = rests(j, balance.laws().single()[j], motion.segment(first, C), omega); !reason.empty())
      return reason;
  }
  return "";
}

/// Of a curve that must not be extended.
std::string KnownForces::out_of_curve(std::size_t j, const VectorXd& motion) const {
  const auto [low, high] = deflections_[j].law.range();
  if (!std::isfinite(low) && !std::isfinite(high)) return "";
  const Index samples = 4 * motion.size();
  for (Index n = 0; n < samples; ++n) {
    const double phase = two_pi * static_cast<double>(n) / static_cast<double>(samples);
    const double deviation = numerics::motion_at((motion.size() - 1) / 2, phase, motion);
    if (deviation < low || deviation > high)
      return fmt::format("{} leaves its curve: {:.6g} from rest, known from {:.6g} to {:.6g}", deflections_[j].name,
                         deviation, low, high);
  }
  return "";
}

std::string KnownForces::out_of_distances(std::size_t j, const Eigen::MatrixXd& motion) const {
  const DistanceAbout& law = *deflections_[j].distance;
  const auto [low, high] = law.range();
  if (!std::isfinite(low) && !std::isfinite(high)) return "";
  const Index samples = 4 * motion.rows();
  for (Index n = 0; n < samples; ++n) {
    const double phase = two_pi * static_cast<double>(n) / static_cast<double>(samples);
    const Eigen::Vector3d here = (numerics::fourier_row((motion.rows() - 1) / 2, phase) * motion).transpose();
    if (const double distance = law.distance(here); distance < low || distance > high)
      return fmt::format("{} reaches a length of {:.6g} m; its forces are known from {:.6g} to {:.6g} m",
                         deflections_[j].name, distance, low, high);
  }
  return "";
}

/// Of friction without a spring: where its deflection turns, the force that would hold it there exceeds the static
/// limit, or it rests for a while, and its force is unknown. The motion of the harmonics has the acceleration without
/// friction there, the mean of those before and after.
std::string KnownForces::rests(std::size_t j, const LawHarmonics& law, const VectorXd& motion, double omega) const {
  const std::vector<LawAbout::Hysteretic>& parts = law.law().hysteretic();
  if (std::none_of(parts.begin(), parts.end(), is_coulomb)) return "";
  const VectorXd acceleration = omega * omega * numerics::phase_derivative(numerics::phase_derivative(motion));
  const LawCourse course = law.course(motion, omega);
  for (const HystereticLoop& loop : course.loops()) {
    const auto* friction = std::get_if<elements::CoulombFriction>(&loop.law());
    if (!friction) continue;
    for (const HystereticLoop::Branch& branch : loop.branches()) {
      const double holds = std::abs(numerics::motion_at((motion.size() - 1) / 2, branch.from, acceleration)) /
          law.law().acceleration_per_force();
      if (!(holds > friction->limit()))
        return fmt::format(
            "the friction of {} rests for a part of the period: {:.4g} would hold it where it turns, and "
            "it holds up to {:.4g}; give it a stiffness, with which it can stick",
            deflections_[j].name, std::max(holds, 0.0), friction->limit());
    }
  }
  return "";
}

}  // namespace trivet::nonlinear
