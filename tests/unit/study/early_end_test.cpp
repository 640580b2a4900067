// SPDX-License-Identifier: BSD-3-Clause
// Searches that are ended after some designs keep the best one so far, with its true values.
#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "support/projects.h"
#include "trivet/study/optimize/optimization.h"

namespace early_end_test {

using namespace trivet;

constexpr double gravity = 9.80665, values = 1e-9, place = 1e-6;  // relative: margins, and the place of an optimum

const std::string machine = R"(
trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 40
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
free = ["z"]
)";

/// True from the call number `after` on.
std::function<bool()> ends_after(int after, std::atomic<int>& calls) {
  return [after, &calls] { return calls++ >= after; };
}

TEST(EarlyEnd, KeepsTheBestNumberSoFar) {
  constexpr double mass = 40, sag = 2e-3, window = 2 * std::numbers::pi * 16;
  const project::Project request = test::project(machine + R"(
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, 1.5e5]
[parameters.k]
path = "elements.s.translation.z"
from = 5e4
to = 1e6
[requirements]
static = {"m.z" = "2 mm"}
natural_frequencies = {avoid = [["16 Hz", "10000 Hz"]]}
)");
  const auto margin = [&](double k) { return std::min(sag * k / (mass * gravity), window / std::sqrt(k / mass)); };
  // s k / (m g) = w √(m / k)
  const double best = std::pow(window * std::sqrt(mass) * mass * gravity / sag, 2.0 / 3);
  double last = 0;
  for (const int designs : {0, 1, 30, 300}) {
    std::atomic<int> calls = 0;
    const study::Optimization found = study::optimization(request, {}, ends_after(designs, calls));
    EXPECT_TRUE(found.cut_short) << designs;
    EXPECT_NEAR(found.objective_after / margin(found.parameters[0].best), 1, values) << designs;
    EXPECT_LE(found.objective_after, margin(best) * (1 + values));
    if (designs == 0) {
      EXPECT_EQ(found.parameters[0].best, 1.5e5) << "not one is judged: the given design";
    }
    last = found.objective_after;
  }
  EXPECT_GT(last / margin(best), 0.9) << "300 designs of one number";
  const study::Optimization whole = study::optimization(request);
  EXPECT_FALSE(whole.cut_short);
  EXPECT_NEAR(whole.parameters[0].best / best, 1, place);
}

TEST(EarlyEnd, KeepsTheBestMountsSoFar) {
  constexpr double sag = 2e-3, window = 2 * std::numbers::pi * 16;
  const double stiffness[] = {79.52e3, 119.3e3, 159e3, 198.8e3};
  const project::Project request = test::project(machine + R"(
[elements.s]
type = "catalogue:disc 20x10 40 ShA"
on = "m"
at = [0, 0, 0]
axis = "z"
[parameters.mount]
path = "elements.s.type"
choices = ["catalogue:disc 20x10 40 ShA", "catalogue:disc 30x15 40 ShA", "catalogue:disc 40x20 40 ShA",
           "catalogue:disc 50x25 40 ShA"]
[parameters.mass]
path = "bodies.m.mass"
from = 5
to = 80
[requirements]
static = {"m.z" = "2 mm"}
natural_frequencies = {avoid = [["16 Hz", "10000 Hz"]]}
[analyses.optimize]
starts = 2
)");
  const auto margin = [&](double k, double m) { return std::min(sag * k / (m * gravity), window / std::sqrt(k / m)); };
  for (const int designs : {2, 40}) {
    std::atomic<int> calls = 0;
    const study::Optimization found = study::optimization(request, {}, ends_after(designs, calls));
    ASSERT_TRUE(found.mounts);
    EXPECT_TRUE(found.cut_short) << designs;
    const double k = stiffness[found.mounts->chosen.at(0)];
    EXPECT_NEAR(found.objective_after / margin(k, found.parameters[0].best), 1, values) << designs;
  }
  EXPECT_FALSE(study::optimization(request).cut_short);
}

}  // namespace early_end_test
