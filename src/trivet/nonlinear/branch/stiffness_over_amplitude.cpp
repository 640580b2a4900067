// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/stiffness_over_amplitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/branch/steady_branch.h"

namespace trivet::nonlinear {
namespace {

/// The element alone between the ground, which moves, and a body so heavy that it rests: it moves by less than a
/// billionth of the ground.
model::System on_test_rig(const model::System& system, std::size_t index, double amplitude, double lowest) {
  constexpr double rests = 1e9;
  model::Description rig;
  model::Body plate;
  plate.name = system.elements()[index].name + " plate";
  model::Element element = system.elements()[index];
  const elements::InnerParts* inner = element.law.inner ? &*element.law.inner : nullptr;
  const double blocked = element.law.scale * element.law.nominal_stiffness(8, 8) + (inner ? inner->stiffness(8, 8) : 0);
  plate.mass.mass = rests * blocked / (lowest * lowest);
  plate.has_inertia = false;
  plate.free = {false, false, true, false, false, false};
  rig.bodies.push_back(std::move(plate));
  const model::Span span = model::span(system.bodies(), element.n, element.k);
  element.k = {0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity(), {}};
  element.n = {{}, -span.arm, span.n_from_k.transpose(), {}};
  rig.elements.push_back(std::move(element));
  model::Excitation motion;
  motion.name = "motion";
  motion.action.amplitude(2) = amplitude;
  motion.course = model::Harmonic();
  rig.excitations.push_back(std::move(motion));
  auto checked = model::System::checked(std::move(rig));
  if (!checked)
    throw std::logic_error("an element of a valid machine is not valid alone: " +
                           foundation::first_message(checked.error()));
  return std::move(*checked);
}

}  // namespace

std::optional<std::complex<double>> AmplitudeStiffness::at(double omega) const {
  constexpr double round_off = 1e-12;
  std::optional<std::complex<double>> found;
  for (std::size_t i = 0; i + 1 < angular_frequency.size(); ++i) {
    const double low = angular_frequency[i] * (1 - round_off), high = angular_frequency[i + 1] * (1 + round_off);
    if (omega < std::min(low, high) || omega > std::max(low, high)) continue;
    const double before = i > 0 ? angular_frequency[i - 1] : 0;
    const bool goes_on = (angular_frequency[i] - before) * (angular_frequency[i + 1] - angular_frequency[i]) > 0;
    if (found && i > 0 && goes_on && std::abs(omega - angular_frequency[i]) <= round_off * omega) continue;  // its end
    if (found) return std::nullopt;
    const double share = (omega - low) / (high - low);
    found = (1 - share) * stiffness(to_index(i)) + share * stiffness(to_index(i) + 1);
  }
  return found;
}

std::vector<AmplitudeStiffness> stiffness_over_amplitude(const model::System& system, std::size_t element, double from,
                                                         double to, const std::vector<double>& amplitudes) {
  SteadyOptions options{.from = from, .to = to};
  options.harmonics = 0;
  options.tolerance = 0.02;  // a picture, for which hundreds of points with many harmonics take too long
  options.most_harmonics = 30;
  options.most_points = 400;
  options.of = {system.elements()[element].name + ".force.z"};
  std::vector<AmplitudeStiffness> found;
  for (const double amplitude : amplitudes) {
    SteadyBranch branch;
    try {
      branch = steady_branch(on_test_rig(system, element, amplitude, from), options);
    } catch (const foundation::NotComputable& reason) {  // the others are worth having
      branch.ended = reason.what();
    }
    if (branch.ended.empty() && branch.left_out > options.tolerance)
      branch.ended =
          fmt::format("{} harmonics leave out up to {:.2g} of the motion", branch.harmonics, branch.left_out);
    AmplitudeStiffness one{amplitude, {}, Eigen::VectorXcd(to_index(branch.points.size())), branch.ended};
    for (const SteadyPoint& point : branch.points) {
      one.stiffness(to_index(one.angular_frequency.size())) = -point.results[0].harmonics(0) / amplitude;
      one.angular_frequency.push_back(point.angular_frequency);
    }
    found.push_back(std::move(one));
  }
  return found;
}

}  // namespace trivet::nonlinear
