// SPDX-License-Identifier: BSD-3-Clause
// A ground given by its acceleration a: masses move relative to it as under the forces −m a, even if both move without
// bound.
#include <gtest/gtest.h>

#include <cmath>

#include "support/projects.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/study/map/design_map.h"

namespace base_acceleration_test {

using namespace trivet;

/// Two masses one above the other, which only move along x and z; the upper one also has a spring to the ground.
std::string tower(const std::string& damping, const std::string& excitations, const std::string& analyses) {
  return "trivet = 1\n[bodies.low]\nmass = 4\nfree = [\"x\", \"z\"]\n[bodies.high]\nmass = 2\nfree = [\"x\", "
         "\"z\"]\nposition = [0, 0, 1]\n"
         "[elements.foot]\ntype = \"bushing\"\non = \"low\"\nat = [0, 0, 0]\ntranslation = [900, 900, 1700]\ndamping "
         "= " +
      damping +
      "\n[elements.neck]\ntype = \"bushing\"\non = \"high\"\nfrom = \"low\"\nat = [0, 0, 0]\ntranslation = [300, 300, "
      "800]\ndamping = " +
      damping + "\n[elements.stay]\ntype = \"bushing\"\non = \"high\"\nat = [0, 0, 0]\ntranslation = [20, 20, 50]\n" +
      excitations + "[analyses]\n" + analyses;
}

const std::string shaken =
    "[excitations.shake]\ntype = \"base\"\nquantity = \"acceleration\"\ntranslation = [0.7, 0, 2]\n";
const std::string pushed =
    "[excitations.low]\ntype = \"harmonic\"\non = \"low\"\nat = [0, 0, 0]\nforce = [-2.8, 0, -8]\n"
    "[excitations.high]\ntype = \"harmonic\"\non = \"high\"\nat = [0, 0, 0]\nforce = [-1.4, 0, -4]\n";

struct Computed {
  model::System system;
  assembly::Assembled assembled;
  std::vector<assembly::Channel> channels;
  assembly::Loading loading;
  Computed(const project::Project& project, const std::vector<std::string>& of)
      : system(project.base().system),
        assembled(assembly::assemble(system)),
        channels(assembly::channels(system, assembled, of, assembly::MotionQuantity::displacement)),
        loading(assembly::harmonic_loading(system, assembled)) {}
};

constexpr double round_off = 1e-11;  // of a solve with the condition of these matrices
constexpr double of_a_float = 2e-7;  // margins are kept in single precision

TEST(BaseAcceleration, MovesMassesAgainstTheGroundAsForcesWouldDownToRest) {
  for (const char* damping : {"{proportional = 0.05}", "{loss_factor = 0.1}"}) {
    const Computed base(test::project(tower(damping, shaken, "response = {band = [0.001, 40]}\n")),
                        {"low.relative", "high.relative", "neck", "foot"});
    const Computed force(test::project(tower(damping, pushed, "response = {band = [0.001, 40]}\n")),
                         {"low", "high", "neck", "foot"});
    const std::vector<double> omega = {1e-8, 1e-6, 1e-5, 1e-3, 1, 11, 17, 300};
    const auto of_base = response::frequency_response(base.assembled, base.channels, base.loading, omega);
    const auto of_force = response::frequency_response(force.assembled, force.channels, force.loading, omega);
    int compared = 0;
    for (const response::Curve& curve : of_force.curves)
      for (const response::Curve& other : of_base.curves) {
        std::string name = other.name;
        if (const auto at = name.find(".relative"); at != std::string::npos) name.erase(at, 9);
        if (name != curve.name || curve.name.find(".force.y") != std::string::npos ||
            curve.name.find("moment") != std::string::npos)
          continue;
        ++compared;
        for (Eigen::Index i = 0; i < std::ssize(omega); ++i)
          EXPECT_LE(std::abs(other.value(i) - curve.value(i)), round_off * std::abs(curve.value(i)))
              << curve.name << " at " << omega[i] << ", damping " << damping;
      }
    EXPECT_EQ(compared, 8);
  }
}

TEST(BaseAcceleration, LeavesTheMotionInSpaceUnbounded) {
  const Computed base(test::project(tower("{proportional = 0.05}", shaken, "response = {band = [0.001, 40]}\n")),
                      {"low.z"});
  const double omega = 1e-4;  // far below the lowest natural frequency: everything moves with the ground
  const auto found = response::frequency_response(base.assembled, base.channels, base.loading, {omega});
  constexpr double square_ratio = 5e-7;  // (1e-4 over the lowest natural frequency, some 10 rad/s)², with room
  EXPECT_NEAR(std::abs(found.curves[0].value(0)), 2 / (omega * omega), square_ratio * 2 / (omega * omega));
}

TEST(BaseAcceleration, HasTheSamePeaksAsForces) {
  const std::string band = "response = {band = [0.001, 40]}\n";
  const project::Project by_base = test::project(tower("{proportional = 0.02}", shaken, band)),
                         by_force = test::project(tower("{proportional = 0.02}", pushed, band));
  const auto peaks = [](const Computed& a) {
    const modal::Modes modes = modal::modes(a.system, a.assembled);
    return response::peaks(a.assembled, a.channels, a.loading, modes, modal::roots(a.system, a.assembled, modes));
  };
  const response::Peaks base = peaks({by_base, {"high.relative.x", "high.relative.z"}}),
                        force = peaks({by_force, {"high.x", "high.z"}});
  ASSERT_EQ(base.list.size(), force.list.size());
  ASSERT_FALSE(base.list.empty());
  for (std::size_t k = 0; k < base.list.size(); ++k) {
    EXPECT_NEAR(base.list[k].amplitude, force.list[k].amplitude, round_off * force.list[k].amplitude);
    EXPECT_NEAR(base.list[k].prominence, force.list[k].prominence, round_off * force.list[k].amplitude);
  }
}

TEST(BaseAcceleration, HasALimitAtRestInEveryAttitude) {
  // Components that are zero except for round-off in turned axes: inclined mounts on turned bodies, a rotating ground.
  constexpr double square_ratio = 1e-7;  // (1e-3 over 20 rad/s)² times levers, and 4e-6 s · 1e-3 rad/s of damping
  int attitudes = 0;
  for (const char* turn :
       {"", "orientation = {axis = \"z\", angle = \"20 deg\"}", "orientation = {axis = [1, 2, 3], angle = \"37 deg\"}"})
    for (const char* axis : {"", "axis = [0, 0.5, 0.866]\n", "axis = [0.3, -0.5, 0.8]\n", "axis = \"y\"\n"})
      for (const char* position : {"[0, 0, 0]", "[1, 2, 0.5]"})
        for (const char* motion : {"rotation = [0, 0.2, 0.1]", "rotation = [0, 0, 0.1]",
                                   "rotation = [0.3, 0.2, 0.1]\ntranslation = [1, 2, 3]\nat = [0.1, 0.7, 0]"}) {
          std::string text = std::string("trivet = 1\n[bodies.m]\nmass = 1000\nposition = ") + position + "\n" + turn +
              "\ninertia = {about = \"center_of_mass\", xx = 90, yy = 150, zz = 160}\n";
          int count = 0;
          for (const char* at : {"[0.7, 0.35, 0]", "[-0.7, 0.35, 0]", "[0, -0.35, 0]"})
            text += "[elements.e" + std::to_string(count++) + "]\ntype = \"bushing\"\non = \"m\"\nat = " + at + "\n" +
                axis + "translation = [3e5, 4e5, 1.2e6]\ndamping = {proportional = 4e-6}\n";
          text += std::string("[excitations.floor]\ntype = \"base\"\nquantity = \"acceleration\"\n") + motion +
              "\n[analyses]\nresponse = {at = [0, 1e-3], of = [\"e0.deflection\", \"e1\", \"m.relative\", "
              "\"ground\"]}\n";
          const project::Project project = test::project(text);
          const study::CaseResults found = study::case_results(project.base(), project.base().analyses);
          for (const auto& curve : found.response->curves.curves) {
            double largest = 0;
            for (const auto& other : found.response->curves.curves)
              if (other.unit == curve.unit) largest = std::max(largest, std::abs(other.value(1)));
            EXPECT_LE(std::abs(curve.value(0) - curve.value(1)), square_ratio * largest) << curve.name << "\n" << text;
          }
          ++attitudes;
        }
  EXPECT_EQ(attitudes, 72);
}

TEST(BaseAcceleration, LetsMapsAskForNoPeakAgainstTheGround) {
  const std::string map =
      "map = {x = {parameter = \"elements.foot.scale\", from = 0.5, to = 2, points = 4}, y = {parameter = "
      "\"elements.foot.damping.proportional\", from = 0.02, to = 3, "
      "points = 4}, no_peak = [\"low";
  const project::Project base = test::project(tower("{proportional = 0.2}", shaken, map + ".relative.z\"]}\n"));
  const project::Project force = test::project(tower("{proportional = 0.2}", pushed, map + ".z\"]}\n"));
  const study::DesignMap a = study::design_map(base, base.base(), *base.base().analyses.map),
                         b = study::design_map(force, force.base(), *force.base().analyses.map);
  int peaks = 0;
  for (std::size_t k = 0; k < a.outcomes.size(); ++k) {
    if (std::isinf(b.outcomes[k].margin)) {  // no peak at all
      EXPECT_EQ(a.outcomes[k].margin, b.outcomes[k].margin) << "design " << k;
      continue;
    }
    ++peaks;
    EXPECT_NEAR(a.outcomes[k].margin, b.outcomes[k].margin, of_a_float * std::abs(b.outcomes[k].margin))
        << "design " << k;
  }
  EXPECT_GT(peaks, 0);
}

TEST(BaseAcceleration, GivesMarginsAtTheStartOfTheBandToAFloat) {
  const std::string map =
      "map = {x = {parameter = \"elements.foot.scale\", from = 0.5, to = 2, points = 4}, y = {parameter = "
      "\"elements.foot.damping.proportional\", from = 0.2, to = 0.3, "
      "points = 2}, limits = {\"high";
  const project::Project base =
      test::project(tower("{proportional = 0.2}", shaken, map + ".relative.z\" = \"20 mm\"}}\n"));
  const project::Project force = test::project(tower("{proportional = 0.2}", pushed, map + ".z\" = \"20 mm\"}}\n"));
  const study::DesignMap a = study::design_map(base, base.base(), *base.base().analyses.map),
                         b = study::design_map(force, force.base(), *force.base().analyses.map);
  for (std::size_t k = 0; k < a.outcomes.size(); ++k)
    EXPECT_NEAR(a.outcomes[k].margin, b.outcomes[k].margin, of_a_float * b.outcomes[k].margin) << "design " << k;
}

}  // namespace base_acceleration_test
