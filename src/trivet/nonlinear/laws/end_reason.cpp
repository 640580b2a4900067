// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/end_reason.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;

std::string just_touched(const Deflection& deflection, const VectorXd& motion) {
  constexpr double near = 2e-3;  // of the amplitude
  const auto [below, above] = deflection.law.untouched();
  const auto [low, high] = numerics::range_of_motion(motion);
  for (const auto& [reached, gap] : {std::pair{low, below}, std::pair{high, above}})
    if (std::isfinite(gap) && std::abs(reached - gap) < near * (high - low) / 2)
      return fmt::format(
          "; {} just touches its stop, {:.4g} {} from rest, where few harmonics are not enough: take more",
          deflection.name, gap, deflection.is_rotation ? "rad" : "m");
  return "";
}

double share_of_slip(const RubbingLoop& loop) {
  double found = 0;
  for (const RubbingLoop::Point& point : loop.points())
    if (point.state == RubbingLoop::State::slips) found += point.weight / two_pi;
  return found;
}

std::string of_friction(const std::string& contact, const RubbingLoop& here, const RubbingLoop& beyond) {
  const auto& points = beyond.points();
  if (std::ranges::any_of(points, [](const RubbingLoop::Point& point) { return !point.force.allFinite(); }))
    return fmt::format("; the friction of {} finds no closed loop: it is too stiff for these motions", contact);
  constexpr double little = 0.1;
  const double slips = share_of_slip(here);
  if (here.always_sticks() == beyond.always_sticks() && !(slips > 0 && slips < little)) return "";
  return fmt::format("; the friction of {} just begins to slip, where its mean changes quickly", contact);
}

std::string of_loops(const std::string& name, const LawOverPeriod& here, const LawOverPeriod& beyond) {
  if (here.loops().size() != beyond.loops().size()) return "";  // one begins to move
  for (std::size_t i = 0; i < here.loops().size(); ++i) {
    const HystereticLoop &now = here.loops()[i], &next = beyond.loops()[i];
    if (now.branches().size() != next.branches().size())
      return fmt::format("; {} turns more or less often in a period beyond, where its friction begins anew", name);
    if (now.sticks() != next.sticks() || now.just_reaches_slip())
      return fmt::format("; the friction of {} just begins to slip, where its mean changes at once", name);
  }
  return "";
}

}  // namespace

std::string end_reason(const std::vector<Deflection>& deflections, const LawSet& laws, const MatrixXd& motion,
                       const MatrixXd& beyond, double omega) {
  for (const LawSet::Rubbing& one : laws.rubbings()) {
    const std::string& name = deflections[one.on[1]].name;
    const std::string found =
        of_friction(name.substr(0, name.find('.')), laws.loop(one, motion, omega), laws.loop(one, beyond, omega));
    if (!found.empty()) return found;
  }
  for (Index j = 0; j < motion.cols(); ++j) {
    const Deflection& deflection = deflections[j];
    if (std::string found = just_touched(deflection, motion.col(j)); !found.empty()) return found;
    if (deflection.law.hysteretic().empty()) continue;
    if (std::string found = of_loops(deflection.name, laws.course(j, motion, omega), laws.course(j, beyond, omega));
        !found.empty())
      return found;
  }
  return "";
}

}  // namespace trivet::nonlinear
