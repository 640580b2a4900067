// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/enough_harmonics.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "trivet/elements/scalar_law.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::nonlinear {
namespace {

bool has_gas(const model::System& system) {
  const auto is_gas = [](const elements::ScalarLaw& law) {
    const auto* elastic = std::get_if<elements::ElasticForce>(&law);
    return elastic && std::holds_alternative<elements::GasForce>(*elastic);
  };
  const auto any = [&](const auto& laws) { return std::ranges::any_of(laws, is_gas); };
  return std::ranges::any_of(system.elements(), [&](const model::Element& element) {
    return std::ranges::any_of(element.nonlinear_parts, [&](const auto& part) { return any(part.laws); }) ||
        std::ranges::any_of(element.distance_parts, [&](const auto& part) { return any(part.law.laws); });
  });
}

}  // namespace

Eigen::Index more_harmonics(Eigen::Index harmonics) { return std::min(most_steady_harmonics, 7 * harmonics / 5); }

void check_harmonics(const SteadyOptions& options, const PeriodicExcitation& excitation) {
  const Eigen::Index highest = excitation.highest();
  if (highest > most_steady_harmonics && options.harmonics == 0)
    throw foundation::NotComputable(
        fmt::format("steady: the highest order is harmonic {} of the motion, and at most {} are taken unless more are "
                    "given; give harmonics = {}, or name excitations whose orders have a larger common divisor",
                    highest, most_steady_harmonics, highest));
  if (options.harmonics > 0 && options.harmonics < highest)
    throw foundation::InvalidInput(fmt::format(
        "steady: {} harmonics, and the highest order is harmonic {} of the motion, of which order {:.6g} is the first; "
        "take at least {}",
        options.harmonics, highest, excitation.first_harmonic, highest));
}

/// Gas hardens without limit as it is compressed: stability depends on a small share of the motion.
double allowed_left_out(const model::System& system, const SteadyOptions& options) {
  constexpr double share_for_gas = 0.1;
  return has_gas(system) ? share_for_gas * options.tolerance : options.tolerance;
}

Eigen::Index harmonics_for(const SteadyPath& curve, double most_left_out, int periods,
                           const std::function<std::unique_ptr<SteadyPath>(Eigen::Index)>& path_with) {
  const auto left_out = [](const SteadyPath& path, const numerics::BranchPoint& point) {
    return path.balance().left_out(point.unknowns, path.driving(point.parameter).omega);
  };
  const std::vector<numerics::BranchPoint>& points = curve.motions().points();
  const auto worst = std::ranges::max_element(
      points, [&](const auto& a, const auto& b) { return left_out(curve, a) < left_out(curve, b); });
  const Eigen::Index deflections = curve.balance().size() / curve.balance().coefficients();
  Eigen::MatrixXd motion = worst->unknowns.reshaped(curve.balance().coefficients(), deflections);
  for (Eigen::Index harmonics = more_harmonics(curve.balance().harmonics() / periods);;
       harmonics = more_harmonics(harmonics)) {
    if (harmonics == most_steady_harmonics) return harmonics;
    const std::unique_ptr<SteadyPath> finer = path_with(harmonics);
    Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(finer->balance().coefficients(), deflections);
    padded.topRows(motion.rows()) = motion;
    const std::optional<numerics::BranchPoint> found = finer->motion_near(padded.reshaped(), worst->parameter);
    if (!found) continue;
    if (left_out(*finer, *found) <= most_left_out) return harmonics;
    motion = found->unknowns.reshaped(finer->balance().coefficients(), deflections);
  }
}

}  // namespace trivet::nonlinear
