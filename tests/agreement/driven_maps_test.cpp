// SPDX-License-Identifier: BSD-3-Clause
// Maps of machines with loss factors, rotating loads, moving ground and limits of forces: designs by poles and residues
// against the same designs assembled and searched one by one.
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/projects.h"
#include "trivet/design/design_rules.h"
#include "trivet/study/map/design_map.h"

namespace trivet {
namespace driven_maps_test {

/// Amplitudes have nine digits in both ways, and margins single precision.
constexpr double single_precision = 2e-7;
/// A relative prominence is known to 1e-6 (design_peaks.h).
constexpr double of_prominence = 2e-6;
/// The kernel must solve most designs.
constexpr double most_are_proven = 0.9;
constexpr double none_need_be_proven = 0;

const std::string loss = "damping = {loss_factor = 0.15}\n";
const std::string viscous = "damping = {translation = [300, 200, 500]}\n";

const std::string pulsation = R"(
[excitations.pulsation]
type = "harmonic"
on = "motor"
at = [0.1, 0.05, 0.3]
force = [20, 60, 250]
moment = [0, 0, 12]
)";
const std::string rotating = R"(
[excitations.rotor]
type = "unbalance"
on = "motor"
at = [0.1, 0, 0.2]
axis = "y"
mass_eccentricity = "20 g m"
)";
std::string ground(const std::string& motion) {
  return R"(
[excitations.ground]
type = "base"
)" + motion +
      "\n";
}

/// A motor on four mounts and, with a raft below, on eight.
std::string machine(const std::string& damping, const std::string& excitation, bool with_raft,
                    const std::string& below = viscous) {
  std::string text = R"(
trivet = 1
[bodies.motor]
mass = 320
center_of_mass = [0.02, -0.01, 0.25]
inertia = {about = "center_of_mass", xx = 14, yy = 22, zz = 24, xy = 0.5}
position = [0, 0, 0.3]
)";
  if (with_raft)
    text += R"(
[bodies.raft]
mass = 260
center_of_mass = [0, 0, 0.06]
inertia = {about = "center_of_mass", xx = 16, yy = 40, zz = 55}
position = [0, 0, 0.1]
)";
  const auto mounts = [&](const std::string& name, const std::string& on, const std::string& from, double along,
                          const std::string& of) {
    for (const double x : {-along, along})
      for (const double y : {-0.25, 0.3}) {
        const std::string at = "[" + std::to_string(x) + ", " + std::to_string(y) + ", 0]\n";
        text += "[elements.\"" + name + (x < 0 ? " rear" : " front") + (y < 0 ? " left" : " right") +
            "\"]\ntype = \"bushing\"\non = \"" + on + "\"\nat = " + at + from +
            "translation = [3e5, 2.5e5, 7e5]\nrotation = [2500, 2000, 1000]\n" + of;
      }
  };
  mounts("mount", "motor", with_raft ? "from = \"raft\"\n" : "", 0.4, damping);
  if (with_raft) mounts("lower", "raft", "", 0.6, below);
  return text + excitation;
}

std::string map_of(const std::string& further, const std::string& quantity = "displacement") {
  return R"(
[analyses.map]
x = {parameter = 'elements."mount front left".scale', from = 0.4, to = 2.5, points = 5, spacing = "logarithmic"}
y = {parameter = 'bodies.motor.mass', from = 250, to = 500, points = 4}
band = ["1 Hz", "60 Hz"]
quantity = ")" +
      quantity + "\"\n" + further;
}

void expect_agreement(const std::string& text, double share = most_are_proven) {
  const project::Project project = test::project(text);
  const auto evaluated = [&](bool fast) {
    return study::design_map(project, project.base(), *project.base().analyses.map, {0, 0, {0, fast}});
  };
  const study::DesignMap many = evaluated(true), one_by_one = evaluated(false);
  EXPECT_GE(static_cast<double>(many.report.proven), share * static_cast<double>(many.outcomes.size()))
      << many.report.summary();
  EXPECT_EQ(one_by_one.report.proven, 0u);
  for (std::size_t d = 0; d < many.outcomes.size(); ++d) {
    const design::DesignOutcome &a = many.outcomes[d], &b = one_by_one.outcomes[d];
    EXPECT_EQ(a.governing, b.governing) << d;
    EXPECT_EQ(a.modes_up_to(), b.modes_up_to()) << d;
    const bool of_amplitude = one_by_one.rules.at(b.governing).kind == design::DesignRule::Kind::amplitude;
    EXPECT_NEAR(a.margin, b.margin, (of_amplitude ? single_precision : of_prominence) * b.margin)
        << d << ", " << one_by_one.rules.at(b.governing).words;
  }
}

const std::string limits = R"(limits = {"motor.z" = 1e-4, "motor.ry" = "5 mrad"})";

TEST(DrivenMaps, WithLossFactorsAgreeWithDesignsOneByOne) {
  for (const bool with_raft : {false, true}) {
    expect_agreement(machine(loss, pulsation, with_raft) + map_of(limits));
    expect_agreement(machine(loss, pulsation, with_raft) + map_of("no_peak = \"motor\"\npeak_tolerance = 1e-2"));
  }
}

/// Without dampers all roots come as ±λ, and heavy loss factors couple the modes strongly: a root that is found from
/// two modes, in both halves alike, leaves the sums of odd powers of the roots right.
TEST(DrivenMaps, WithHeavyLossFactorsAndNoDampersAgreeWithDesignsOneByOne) {
  for (const double eta : {0.6, 1.2, 1.6, 1.8, 2.0})
    for (const double stiff : {0.2, 1.0, 4.0}) {
      const std::string heavy =
          "damping = {loss_factor = " + std::to_string(eta) + "}\nscale = " + std::to_string(stiff);
      expect_agreement(machine(heavy + "\n", pulsation, true, "damping = {loss_factor = 0.08}\n") +
                           map_of(R"(limits = {"motor.z" = 1e-4, "motor.ry" = "5 mrad", "raft.y" = "1e-5 m"})"),
                       none_need_be_proven);
    }
}

TEST(DrivenMaps, WithForcesOfTheVariedElementsAgreeWithDesignsOneByOne) {
  for (const std::string& damping : {loss, viscous})
    expect_agreement(machine(damping, pulsation, false) +
                     map_of(R"(limits = {"mount front left.force.z" = 100, "ground.force.z" = 300})"));
}

TEST(DrivenMaps, UnderARotatingUnbalanceAgreeWithDesignsOneByOne) {
  for (const std::string& damping : {loss, viscous}) {
    expect_agreement(machine(damping, rotating, false) + map_of(limits));
    expect_agreement(machine(damping, rotating, false) + map_of("no_peak = \"motor.z\""));
  }
}

TEST(DrivenMaps, OnAMovingGroundAgreeWithDesignsOneByOne) {
  for (const std::string& damping : {loss, viscous}) {
    expect_agreement(machine(damping, ground("translation = [0, 0, 1e-4]\n"), false) + map_of(limits));
    expect_agreement(machine(damping, ground("quantity = \"acceleration\"\ntranslation = [0.1, 0, 0.3]\n"), false) +
                     map_of(R"(limits = {"motor.relative.z" = 1e-4, "mount front left.force.z" = 100})"));
    expect_agreement(machine(damping, ground("quantity = \"acceleration\"\ntranslation = [0.1, 0, 0.3]\n"), false) +
                     map_of(R"(limits = {"motor.z" = "0.5 m/s2", "motor.ry" = "2 rad/s2"})", "acceleration"));
  }
}

}  // namespace driven_maps_test
}  // namespace trivet
