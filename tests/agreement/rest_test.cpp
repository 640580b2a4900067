// SPDX-License-Identifier: BSD-3-Clause
// The state at rest of models with preload and of models with rigid-body modes: equivalent descriptions give the same
// results.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "support/projects.h"
#include "trivet/assembly/assembled.h"
#include "trivet/assembly/channels.h"
#include "trivet/modal/roots.h"
#include "trivet/response/steady/static_response.h"

namespace rest_test {

using namespace trivet;

/// A body on a preloaded link, and a heavy body next to it on a stress-free bushing, with its pole `lift` above the
/// bushing.
std::string beside_a_preload(double lift) {
  return fmt::format(
      "trivet = 1\ngravity = [0, 0, -9.80665]\n"
      "[bodies.hung]\nmass = 10\ninertia = {{about = \"pole\", xx = 1, yy = 1, zz = 1}}\n"
      "[bodies.other]\nmass = 500\nposition = [3, 0, {0:}]\ncenter_of_mass = [0, 0, {1:}]\n"
      "inertia = {{about = \"center_of_mass\", xx = 5, yy = 6, zz = 7}}\n"
      "[elements.link]\ntype = \"link\"\nlength = 0.3\nstiffness = 2e6\ntension = 98.0665\naxis = \"-z\"\non = "
      "\"hung\"\nat = [0, 0, 0]\n"
      "[elements.guide]\ntype = \"bushing\"\non = \"hung\"\nat = [0, 0, 0]\ntranslation = [1e5, 1e5, 0]\nrotation = "
      "[1e3, 1e3, 1e3]\n"
      "[elements.bushing]\ntype = \"bushing\"\non = \"other\"\nat = [0, 0, {2:}]\ntranslation = [1e4, 1e4, "
      "1e4]\nrotation = [1e3, 1e3, 1e3]\n",
      lift, 0.1 - lift, -lift);
}

TEST(GeometricStiffness, DoesNotChangeABodyWithoutPreloadForAnyPole) {
  constexpr double round_off = 1e-10;  // of ω²: n ε times the spread of the eigenvalues
  const auto low = test::project(beside_a_preload(0)), high = test::project(beside_a_preload(0.5));
  const modal::Modes a = modal::modes(low.base().system), b = modal::modes(high.base().system);
  ASSERT_EQ(a.list.size(), b.list.size());
  for (std::size_t i = 0; i < a.list.size(); ++i)
    EXPECT_NEAR(a.list[i].eigenvalue_squared, b.list[i].eigenvalue_squared, round_off * b.list[i].eigenvalue_squared)
        << "mode " << i + 1;
}

TEST(StaticResponse, AWeightThatPreloadsCarryMovesNothing) {
  constexpr double round_off = 1e-9;  // of the weight
  const auto project = test::project(beside_a_preload(0));
  const auto& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto result = response::static_response(system, assembled, {"hung", "link"});
  for (const auto& value : result.values) {
    if (value.name == "hung.z") {
      EXPECT_NEAR(value.value, 0, round_off * 98.0665 / 2e6);
    }
    if (value.name == "link.force.z") {
      EXPECT_NEAR(value.value, -98.0665, round_off * 98.0665);
    }
  }
}

TEST(Roots, ASlowVibrationOfAMachineWithARigidBodyModeIsNoRigidMotion) {
  const auto project = test::project(
      "trivet = 1\n[bodies.sledge]\nmass = 10\nfree = [\"x\", \"z\"]\n"
      "[elements.mount]\ntype = \"three_springs\"\non = \"sledge\"\nat = [0, 0, 0]\ntranslation = [0, 0, 400]\n"
      "damping = {fractional_zener = {ratio = 0.5, time = 1e-4, order = 0.5}}\n");
  const modal::Roots roots = modal::roots(project.base().system);
  int rigid = 0, oscillating = 0;
  for (const modal::Root& root : roots.list) {
    rigid += root.kind == modal::RootKind::rigid ? 1 : 0;
    oscillating += root.kind == modal::RootKind::oscillating ? 1 : 0;
  }
  EXPECT_EQ(rigid, 2);
  EXPECT_EQ(oscillating, 2);
}

TEST(Limits, AreJudgedInABandNearTheEndOfATable) {
  const auto project = test::project(
      fmt::format("trivet = 1\n[bodies.frame]\nmass = 10\nfree = [\"z\"]\n"
                  "[elements.mount]\ntype = \"table\"\non = \"frame\"\nat = [0, 0, 0]\naxis = \"z\"\n"
                  "file = \"{}/tests/samples/data/air_spring.csv\"\n"
                  "[excitations.push]\ntype = \"harmonic\"\non = \"frame\"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n"
                  "[analyses]\nresponse = {{of = [\"frame\"], band = [\"50 Hz\", \"100 Hz\"]}}\n"
                  "[limits]\n\"frame.z\" = \"1 mm\"\n",
                  TRIVET_SOURCE_DIR));
  const study::CaseResults result = study::case_results(project.base(), project.base().analyses, {});
  ASSERT_EQ(result.limits.size(), 1u);
  EXPECT_TRUE(result.limits[0].met);
  EXPECT_TRUE(result.failures.empty());
}

}  // namespace rest_test
