// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/detached_motions.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// Typical deviations of a deflection: under the load, and to its nearest kinks.
std::vector<double> sizes(const SteadyPath& path, const std::vector<Deflection>& deflections, double parameter) {
  const Index C = path.balance().coefficients();
  const VectorXd linear = path.balance().linear_motion(path.driving(parameter));
  double largest = 0;
  std::vector<double> found;
  for (Index j = 0; j < to_index(deflections.size()); ++j) {
    double size = linear.segment(j * C, C).norm();
    for (const double kink : deflections[to_size(j)].law.kinks()) size = std::max(size, std::abs(kink));
    found.push_back(size);
    largest = std::max(largest, size);
  }
  for (std::size_t j = 0; j < deflections.size(); ++j)
    if (deflections[j].distance)
      for (std::size_t a = j; a < j + 3; ++a) found[a] = std::max(found[a], deflections[j].distance->extent());
  constexpr double least = 1e-3;
  for (double& size : found) size = std::max(size, least * largest);
  return found;
}

/// Amplitudes between a fifth and twenty times the typical ones, in the excited harmonics.
VectorXd random_motion(const std::vector<double>& of_size, const HarmonicBalance& balance, std::mt19937_64& random) {
  std::uniform_real_distribution<double> logarithm(std::log(0.2), std::log(20.0)), phase(0, foundation::two_pi);
  std::normal_distribution<double> mean(0, 0.3);
  const Index coefficients = balance.coefficients();
  VectorXd motion = VectorXd::Zero(balance.size());
  for (std::size_t j = 0; j < of_size.size(); ++j) motion(to_index(j) * coefficients) = mean(random) * of_size[j];
  for (const Index k : balance.excited()) {
    const double common = std::exp(logarithm(random)), common_phase = phase(random);
    for (std::size_t j = 0; j < of_size.size(); ++j) {
      const double own = common * of_size[j] * std::exp(0.5 * mean(random)),
                   turned = common_phase + mean(random) * foundation::two_pi;
      const Index cosine = to_index(j) * coefficients + 2 * k - 1;
      motion(cosine) = own * std::cos(turned);
      motion(cosine + 1) = own * std::sin(turned);
    }
  }
  return motion;
}

/// The same motion of a symmetric machine half a period later with the other sign: even harmonics change their sign.
VectorXd mirrored(const VectorXd& unknowns, Index coefficients) {
  VectorXd image = unknowns;
  for (Index i = 0; i < unknowns.size(); ++i)
    if ((i % coefficients + 1) / 2 % 2 == 0) image(i) = -image(i);
  return image;
}

}  // namespace

DetachedPaths detached_paths(const SteadyPath& connected, const std::vector<const SteadyPath*>& known,
                             const std::vector<Deflection>& deflections, const std::vector<VectorXd>& rests,
                             const ResonancesAtLoad& resonances, const SteadyOptions& options,
                             const std::function<std::unique_ptr<SteadyPath>()>& new_path,
                             const foundation::Progress& progress) {
  constexpr int places = 24, starts = 16;
  constexpr double same = 1e-3;  // of the motion
  DetachedPaths found{{places, places * starts, static_cast<int>(rests.size()), resonances.curves,
                       options.over == Parameter::frequency ? load_of_search : 0},
                      {}};
  const auto is_known = [&](const BranchPoint& motion) {
    const VectorXd image = mirrored(motion.unknowns, connected.balance().coefficients());
    const auto lies_on = [&](const SteadyPath& path) {
      constexpr std::size_t followed = 2;  // points; else the motion alone
      std::vector<BranchPoint> there = path.motions().all_at(motion.parameter);
      if (path.motions().points().size() < followed && path.motions().points().front().parameter == motion.parameter)
        there = path.motions().points();
      return std::any_of(there.begin(), there.end(), [&](const BranchPoint& other) {
        return path.balance().are_same(other.unknowns, motion.unknowns, same) ||
            path.balance().are_same(other.unknowns, image, same);
      });
    };
    return std::any_of(known.begin(), known.end(), [&](const SteadyPath* path) { return lies_on(*path); }) ||
        std::any_of(found.paths.begin(), found.paths.end(), [&](const auto& path) { return lies_on(*path); });
  };
  const auto take = [&](const BranchPoint& motion) {
    if (is_known(motion)) return;
    std::unique_ptr<SteadyPath> path = new_path();
    path->follow_detached(motion, progress);
    found.paths.push_back(std::move(path));
  };
  for (const SteadyEquations::Place& there : resonances.motions)
    if (there.parameter > options.from && there.parameter < options.to)
      if (const std::optional<BranchPoint> motion = connected.motion_near(there.unknowns, there.parameter))
        take(*motion);
  std::mt19937_64 random(20261126);
  for (int i = 0; i < places; ++i) {
    const double parameter = options.from + (options.to - options.from) * (i + 0.5) / places;
    if (options.over == Parameter::frequency)
      for (const BranchPoint& motion : connected.motions_over_load(parameter, load_of_search)) take(motion);
    const std::vector<double> of_size = sizes(connected, deflections, parameter);
    for (int s = 0; s < starts; ++s)
      if (const std::optional<BranchPoint> motion =
              connected.motion_near(random_motion(of_size, connected.balance(), random), parameter))
        take(*motion);
    for (const VectorXd& rest : rests) {
      VectorXd guess = connected.balance().linear_motion(connected.driving(parameter));
      for (Index j = 0; j < rest.size(); ++j) guess(j * connected.balance().coefficients()) = rest(j);
      if (const std::optional<BranchPoint> motion = connected.motion_near(guess, parameter)) take(*motion);
    }
    foundation::report_progress(progress, "detached motions", (i + 1.0) / places);
  }
  return found;
}

}  // namespace trivet::nonlinear
