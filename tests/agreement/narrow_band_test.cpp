// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/projects.h"
#include "trivet/foundation/constants.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Narrow bands, in which motions have no connection that a wide band shows.
namespace narrow_band_test {

using namespace trivet;
using foundation::two_pi;
using nonlinear::SteadyBranch;

/// Two struts that push against a spring: a symmetric machine with a quasi-zero stiffness.
const std::string isolator = R"(trivet = 1
[bodies.m]
mass = 25
free = ["z"]
[elements.up]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 3210]
damping = {translation = [0, 0, 8]}
[elements.l]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [-0.1, 0, 0]
free_length = 0.14
stiffness = 4000
[elements.r]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [0.1, 0, 0]
free_length = 0.14
stiffness = 4000
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 3]
)";

SteadyBranch followed(const std::string& text, nonlinear::SteadyOptions options, double from, double to,
                      std::vector<double> at) {
  options.from = two_pi * from;
  options.to = two_pi * to;
  for (double& place : at) place *= two_pi;
  options.at = std::move(at);
  return nonlinear::steady_branch(test::project(text).base().system, options);
}

/// The largest mean of the stable motions that a branch and its further curves have where it was requested.
double largest_stable_mean(const SteadyBranch& branch) {
  double mean = 0;
  for (const nonlinear::SteadyPoint& point : branch.at)
    if (point.stable) mean = std::max(mean, std::abs(point.results[0].mean));
  for (const SteadyBranch& curve : branch.further) mean = std::max(mean, largest_stable_mean(curve));
  return mean;
}

/// The symmetric motion has lost its stability there to a pair with a mean, which a wide band reaches through branch
/// points.
TEST(NarrowBand, SearchFindsTheStablePairBesideAnUnstableMotion) {
  constexpr double same = 1e-6;
  const nonlinear::SteadyOptions options{.harmonics = 9, .of = {"m.z"}};
  nonlinear::SteadyOptions with_search = options;
  with_search.detached = true;
  const SteadyBranch wide = followed(isolator, options, 0.15, 0.35, {0.2425}),
                     narrow = followed(isolator, with_search, 0.24, 0.245, {0.2425});
  ASSERT_EQ(wide.at.size(), 1u);
  EXPECT_FALSE(wide.at[0].stable);
  ASSERT_GT(largest_stable_mean(wide), 1e-3);
  EXPECT_NEAR(largest_stable_mean(narrow) / largest_stable_mean(wide), 1, same);
}

}  // namespace narrow_band_test
