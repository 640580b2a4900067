// SPDX-License-Identifier: BSD-3-Clause
// Nodes against closed forms: springs in series, a dashpot in series with a spring, and frames of slender beams. Sway
// stiffness of a portal frame: A. K. Chopra, Dynamics of Structures, 1995, section 1.3.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/index.h"

namespace nodes_test {

using namespace trivet;
using test::RelativelyNear;
using Complex = std::complex<double>;

constexpr double of_two_solves = 1e-12;  // round-off of systems of two coordinates
constexpr double of_a_peak = 1e-10;      // round-off of the search for a maximum
constexpr double of_long_beams = 1e-9;   // round-off of slender beams: condition 1e6 of their stiffness
constexpr double of_stiff_axes = 1e-4;   // the closed form has beams that do not stretch: EA L²/EI is about 1e6 here

study::CaseResults results_of(const std::string& text) {
  const project::Project project = test::project(text);
  return study::case_results(project.base(), project.base().analyses);
}

double static_value(const study::CaseResults& found, const std::string& name) {
  for (const response::StaticValue& value : found.statics->values)
    if (value.name == name) return value.value;
  ADD_FAILURE() << "no static result " << name;
  return 0;
}

constexpr double mass = 12, lower = 7e4, upper = 3e4;

/// A guided mass above a node.
std::string in_series(const std::string& upper_more, const std::string& lower_element, const std::string& analyses) {
  return fmt::format(R"(trivet = 1
[bodies.m]
mass = {}
free = ["z"]
position = [0, 0, 0.2]
[nodes.joint]
position = [0, 0, 0.1]
free = ["z"]
[elements.upper]
type = "three_springs"
on = "m"
at = [0, 0, 0]
from = "joint"
translation = [1e4, 1e4, {}]
{}
{}
[excitations.push]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 5]
[excitations.weight]
type = "constant"
on = "m"
at = [0, 0, 0]
force = [0, 0, -40]
[analyses]
{}
)",
                     mass, upper, upper_more, lower_element, analyses);
}

std::string spring_below(double loss_factor) {
  return fmt::format(
      "[elements.lower]\ntype = \"three_springs\"\non = \"joint\"\ntranslation = [2e4, 2e4, {}]\ndamping = "
      "{{loss_factor "
      "= {}}}\n",
      lower, loss_factor);
}

TEST(Nodes, TwoSpringsInSeriesAreOneSpringAtRestAndInModes) {
  const double k = lower * upper / (lower + upper);
  const study::CaseResults found = results_of(
      in_series("", spring_below(0), "modes = {}\nroots = {}\nstatic = {of = [\"m\", \"joint\", \"lower\"]}\n"));
  ASSERT_EQ(found.modes.list.size(), 1u);
  EXPECT_THAT(*found.modes.list[0].angular_frequency, RelativelyNear(std::sqrt(k / mass), of_two_solves));
  // The node follows the mass as the upper end of the lower spring.
  EXPECT_THAT(found.modes.list[0].shape(8) / found.modes.list[0].shape(2),
              RelativelyNear(upper / (lower + upper), of_two_solves));
  for (const modal::Root& root : found.roots.list)
    EXPECT_THAT(std::abs(root.eigenvalue), RelativelyNear(std::sqrt(k / mass), of_two_solves));
  EXPECT_EQ(found.roots.list.size(), 2u);
  EXPECT_THAT(static_value(found, "m.z"), RelativelyNear(-40 / k, of_two_solves));
  EXPECT_THAT(static_value(found, "joint.z"), RelativelyNear(-40 / lower, of_two_solves));
  EXPECT_THAT(static_value(found, "lower.force.z"), RelativelyNear(-40.0, of_two_solves));
}

TEST(Nodes, TwoLossySpringsInSeriesAreOneSpringInResponseAndPeaks) {
  const Complex k = 1.0 / (1.0 / (lower * Complex(1, 0.2)) + 1.0 / (upper * Complex(1, 0.04)));
  const study::CaseResults found =
      results_of(in_series("damping = {loss_factor = 0.04}", spring_below(0.2),
                           "response = {at = [3, 40, 41.83, 200], of = [\"m\", \"joint\"]}\npeaks = {of = [\"m\"]}\n"));
  const double omegas[] = {3, 40, 41.83, 200};
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Complex exact = 5.0 / (k - omegas[i] * omegas[i] * mass);
    EXPECT_LT(std::abs(test::value(*found.response, "m.z", i) - exact), of_two_solves * std::abs(exact));
    const Complex below = exact * upper * Complex(1, 0.04) / (upper * Complex(1, 0.04) + lower * Complex(1, 0.2));
    EXPECT_LT(std::abs(test::value(*found.response, "joint.z", i) - below), of_two_solves * std::abs(below));
  }
  ASSERT_EQ(found.peaks->peaks.list.size(), 1u);
  EXPECT_THAT(found.peaks->peaks.list[0].angular_frequency, RelativelyNear(std::sqrt(k.real() / mass), of_a_peak));
  EXPECT_THAT(found.peaks->peaks.list[0].amplitude, RelativelyNear(5 / k.imag(), of_a_peak));
}

/// The spring on the node is in series with a dashpot to the ground, and a second spring is parallel to both.
TEST(Nodes, ASpringAndADashpotInSeriesAreAMaxwellBranch) {
  constexpr double dashpot = 900, parallel = 2e4;
  const std::string below = fmt::format(R"([elements.dashpot]
type = "damper"
on = "joint"
from_at = [0, 0, 0]
coefficient = {}
[elements.parallel]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [1e4, 1e4, {}]
)",
                                        dashpot, parallel);
  const study::CaseResults found =
      results_of(in_series("", below, "roots = {}\nmodes = {}\nresponse = {at = [1, 30, 60, 400], of = [\"m\"]}\n"));
  const double omegas[] = {1, 30, 60, 400};
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Complex s(0, omegas[i]);
    const Complex exact = 5.0 / (parallel + upper * s * dashpot / (upper + s * dashpot) + s * s * mass);
    EXPECT_LT(std::abs(test::value(*found.response, "m.z", i) - exact), of_two_solves * std::abs(exact));
  }
  // (k₀ + m λ²)(k + cλ) + k c λ = 0
  ASSERT_EQ(found.roots.list.size(), 3u);
  for (const modal::Root& root : found.roots.list) {
    const Complex l = root.eigenvalue;
    const Complex a = (parallel + mass * l * l) * (upper + dashpot * l), b = upper * dashpot * l;
    EXPECT_LT(std::abs(a + b), of_a_peak * (std::abs(a) + std::abs(b)));
  }
  EXPECT_THAT(*found.modes.list.at(0).angular_frequency, RelativelyNear(std::sqrt(parallel / mass), of_two_solves));
}

/// A node between a mass and the ground, with a dashpot at 36.87° to the springs: it damps one of two directions.
TEST(Nodes, ASkewDashpotDampsOneDirectionOfThem) {
  constexpr double dashpot = 700, across = 5e4, up = 2e4;
  const study::CaseResults found = results_of(fmt::format(R"(trivet = 1
[bodies.m]
mass = {}
free = ["x", "z"]
position = [0, 0, 0.2]
[nodes.joint]
position = [0, 0, 0.1]
[elements.upper]
type = "three_springs"
on = "m"
at = [0, 0, -0.1]
from = "joint"
translation = [{}, 1e4, {}]
[elements.dashpot]
type = "damper"
on = "joint"
from_at = [0.3, 0, -0.3]
coefficient = {}
[elements.lower]
type = "three_springs"
on = "joint"
translation = [3e4, 1e4, 3e4]
[analyses]
roots = {{}}
)",
                                                          mass, across, up, dashpot));
  const Eigen::Vector2d n(0.6, -0.8);
  const auto dynamic_stiffness = [&](Complex s) {
    Eigen::Matrix4cd z = Eigen::Matrix4cd::Zero();
    const Eigen::Matrix2cd k = Eigen::Vector2d(across, up).cast<Complex>().asDiagonal();
    z << k + mass * s * s * Eigen::Matrix2cd::Identity(), -k, -k,
        k + 3e4 * Eigen::Matrix2cd::Identity() + s * dashpot * (n * n.transpose()).cast<Complex>();
    return z;
  };
  ASSERT_EQ(found.roots.list.size(), 5u);  // two for each motion of the mass, one relaxation along the dashpot
  for (const modal::Root& root : found.roots.list) {
    Eigen::Vector4cd motion;
    motion << root.shape(0), root.shape(2), root.shape(6), root.shape(8);
    const Eigen::Matrix4cd z = dynamic_stiffness(root.eigenvalue);
    EXPECT_LT((z * motion).norm(), of_a_peak * z.norm() * motion.norm()) << root.eigenvalue;
  }
}

constexpr double steel = 2.1e11, moment = 4e-8, section_area = 5e-3;

/// Euler–Bernoulli beams: the shear factor is so large that shear is below round-off.
std::string beam(const std::string& name, const std::string& ends, double moment_of_area = moment) {
  return fmt::format(
      "[elements.\"{}\"]\ntype = \"beam\"\nlevel = \"quasi_static\"\nmaterial = {{E = {}, nu = "
      "0.3}}\n"
      "section = {{area = {}, moment_x = {}, moment_y = {}, torsion = 1e-8, shear_factor_x = 1e9, shear_factor_y = "
      "1e9}}\n{}\n",
      name, steel, section_area, moment_of_area, moment_of_area, ends);
}

/// Beams end to end along x through nodes, from the ground at the origin to x = `length`.
std::string cantilever(int parts, double length, const std::string& tip) {
  std::string text;
  for (int i = 1; i < parts; ++i) text += fmt::format("[nodes.n{}]\nposition = [{}, 0, 0]\n", i, i * length / parts);
  for (int i = 1; i <= parts; ++i)
    text += beam(fmt::format("b{}", i),
                 (i < parts ? fmt::format("on = \"n{}\"\n", i) : tip) +
                     (i == 1 ? "from_at = [0, 0, 0]\n" : fmt::format("from = \"n{}\"\n", i - 1)));
  return text;
}

TEST(Nodes, BeamsEndToEndAreACantileverOf3EIOverLCubed) {
  constexpr double length = 1.7;
  const double k = 3 * steel * moment / std::pow(length, 3);
  for (const int parts : {1, 2, 5}) {
    const study::CaseResults found = results_of(
        fmt::format("trivet = 1\n[bodies.m]\nmass = 20\ninertia = {{about = \"pole\", xx = 1e-9, yy = 1e-9, zz = "
                    "1e-9}}\nposition = [{}, 0, 0]\n",
                    length) +
        cantilever(parts, length, "on = \"m\"\nat = [0, 0, 0]\n") +
        "[excitations.f]\ntype = \"constant\"\non = \"m\"\nat = [0, 0, 0]\nforce = [0, 30, 0]\n"
        "[analyses]\nmodes = {}\nstatic = {of = [\"m\"]}\n");
    EXPECT_THAT(static_value(found, "m.y"), RelativelyNear(30 / k, of_long_beams)) << parts;
    EXPECT_THAT(static_value(found, "m.rz"), RelativelyNear(30 * length * length / (2 * steel * moment), of_long_beams))
        << parts;
    ASSERT_EQ(found.modes.list.size(), 6u) << parts;
    EXPECT_THAT(*found.modes.list[0].angular_frequency, RelativelyNear(std::sqrt(k / 20), of_long_beams)) << parts;
  }
}

TEST(Nodes, TwoLegsInPartsUnderARigidDeckHave12EIOverLCubedEach) {
  constexpr double height = 1.2;
  const double k = 2 * 12 * steel * moment / std::pow(height, 3);
  std::string legs;
  for (const char* side : {"left", "right"}) {
    const double y = side[0] == 'l' ? 0.5 : -0.5;
    legs += fmt::format("[nodes.{}]\nposition = [0, {}, 0.5]\n", side, y) +
        beam(std::string("foot ") + side, fmt::format("on = \"{}\"\nfrom_at = [0, {}, 0]", side, y)) +
        beam(std::string("head ") + side, fmt::format("on = \"deck\"\nat = [0, {}, 0]\nfrom = \"{}\"", y, side));
  }
  const study::CaseResults found =
      results_of(fmt::format("trivet = 1\n[bodies.deck]\nmass = 500\nfree = [\"x\"]\nposition = [0, 0, {}]\n", height) +
                 legs + "[analyses]\nmodes = {}\n");
  ASSERT_EQ(found.modes.list.size(), 1u);
  EXPECT_THAT(*found.modes.list[0].angular_frequency, RelativelyNear(std::sqrt(k / 500), of_long_beams));
}

/// k = 24 EI/h³ (12ρ + 1)/(12ρ + 4), ρ = I_girder / 4 I_column, width 2h.
TEST(Nodes, PortalFrameHasTheSwayStiffnessOfTheTextbook) {
  constexpr double height = 1.1;
  for (const double girder : {0.2, 1.0, 20.0}) {
    const double rho = girder / 4, k = 24 * steel * moment / std::pow(height, 3) * (12 * rho + 1) / (12 * rho + 4);
    const std::string frame =
        fmt::format("[nodes.a]\nposition = [0, 0, {0}]\n[nodes.b]\nposition = [{1}, 0, {0}]\n", height, 2 * height) +
        beam("left", "on = \"a\"\nfrom_at = [0, 0, 0]") +
        beam("right", fmt::format("on = \"b\"\nfrom_at = [{}, 0, 0]", 2 * height)) +
        beam("girder", "on = \"a\"\nfrom = \"b\"", girder * moment);
    const study::CaseResults found = results_of(
        "trivet = 1\n[bodies.m]\nmass = 1\nfree = [\"x\"]\n[elements.s]\ntype = \"three_springs\"\non = \"m\"\nat = "
        "[0, "
        "0, 0]\ntranslation = [1, 1, 1]\n" +
        frame +
        "[excitations.left]\ntype = \"constant\"\non = \"a\"\nforce = [50, 0, 0]\n"
        "[excitations.right]\ntype = \"constant\"\non = \"b\"\nforce = [50, 0, 0]\n"
        "[analyses]\nstatic = {of = [\"a\", \"b\"]}\n");
    EXPECT_THAT(static_value(found, "a.x"), RelativelyNear(100 / k, of_stiff_axes)) << girder;
    EXPECT_THAT(static_value(found, "b.x"), RelativelyNear(100 / k, of_stiff_axes)) << girder;
  }
}

}  // namespace nodes_test
