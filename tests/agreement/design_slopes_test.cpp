// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/projects.h"
#include "trivet/study/optimize/design_objective.h"

/// Slopes of the margins of requirements: from derivatives of the assembled model, and from differences of the margins
/// of models that are read and solved again.
namespace design_slopes_test {

using namespace trivet;

/// Differences of the eighth order over ± 4 steps, so short that none reaches the next kink of a margin; the margins
/// have ten digits and more.
constexpr double step = 5e-5, differences = 2e-6;

/// A skew body and a smaller one on it, with all kinds of damping; numbers change with the seed.
std::string machine(unsigned seed, const std::string& damping) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> around(0.8, 1.25);
  const auto some = [&](double value) { return fmt::format("{}", value * around(random)); };
  std::string text = "trivet = 1\ngravity = [0, 0, -9.80665]\n";
  text += "[bodies.machine]\nmass = " + some(120) + "\ncenter_of_mass = [" + some(0.03) + ", 0.02, " + some(0.2) +
      "]\ninertia = {about = \"center_of_mass\", xx = " + some(6) + ", yy = " + some(9) + ", zz = " + some(7) +
      ", xy = 0.4, xz = -0.7}\npoints.seat = [0.3, 0.1, 0.4]\n";
  text += "[bodies.box]\nmass = " + some(8) + "\nposition = [0.1, 0.05, 0.5]\nfree = [\"x\", \"y\", \"z\"]\n";
  for (const auto& [name, x, y] : {std::tuple{"a", 0.4, 0.3}, {"b", -0.4, 0.3}, {"c", 0.4, -0.3}, {"d", -0.4, -0.3}})
    text += fmt::format(
        "[elements.{}]\ntype = \"bushing\"\non = \"machine\"\nat = [{}, {}, 0]\ntranslation = [{}, {}, {}]\nrotation = "
        "[20, 20, 20]\norientation = {{axis = [1, 0.3, 0.1], angle = {}}}\n{}",
        name, x, y, some(9e4), some(7e4), some(2e5), some(0.3), damping);
  text +=
      "[elements.link]\ntype = \"bushing\"\non = \"box\"\nfrom = \"machine\"\nat = [0, 0, 0]\ntranslation = [4e4, "
      "3e4, " +
      some(6e4) + "]\ndamping = {loss_factor = 0.05}\n";
  text += "[excitations.f]\ntype = \"harmonic\"\non = \"machine\"\nat = [0.2, 0.1, 0.3]\nforce = [20, 10, 50]\n";
  text +=
      "[parameters.scale]\npath = [\"elements.a.scale\", \"elements.b.scale\"]\nfrom = 0.5\nto = 2\nspacing = "
      "\"logarithmic\"\n"
      "[parameters.spread]\npath = {\"elements.c.at.y\" = 1, \"elements.a.at.y\" = -1}\nfrom = -0.5\nto = -0.1\n"
      "[parameters.mass]\npath = \"bodies.box.mass\"\nfrom = 5\nto = 15\n"
      "[parameters.link]\npath = \"elements.link.translation.z\"\nfrom = 2e4\nto = 2e5\nspacing = \"logarithmic\"\n"
      "[analyses.response]\nband = [\"1 Hz\", \"25 Hz\"]\n"
      "[requirements]\nlimits = {\"machine.seat.z\" = \"1 mm\", \"box.x\" = \"3 mm/s\", \"ground.force.z\" = 300, "
      "\"link.deflection.z\" = \"0.2 mm\"}\nno_peak = \"machine.seat.z\"\n"
      "natural_frequencies = {avoid = [[\"14 Hz\", \"15 Hz\"]], separation = 1.1}\nstatic = {\"machine.z\" = \"5 "
      "mm\"}\n"
      "decoupling = {machine = \"70 %\"}\n";
  return text;
}

void expect_slopes_of(const std::string& text) {
  const project::Project project = test::project(text);
  const study::DesignObjective objective(project, {});
  const auto n = static_cast<Eigen::Index>(objective.space().size());
  Eigen::VectorXd here(n), values;
  for (Eigen::Index j = 0; j < n; ++j) here(j) = 0.37 + 0.11 * static_cast<double>(j);
  Eigen::MatrixXd slopes;
  objective.evaluate(here, values, &slopes);
  const double largest = slopes.cwiseAbs().maxCoeff();
  int compared = 0;
  for (Eigen::Index j = 0; j < n; ++j) {
    Eigen::VectorXd quotient = Eigen::VectorXd::Zero(values.size());
    for (const auto& [node, weight] : {std::pair{1, 4.0 / 5}, {2, -1.0 / 5}, {3, 4.0 / 105}, {4, -1.0 / 280}})
      for (const int sign : {1, -1}) {
        Eigen::VectorXd moved = here, there;
        moved(j) += sign * node * step;
        objective.evaluate(moved, there, nullptr);
        quotient += sign * weight / step * there;
      }
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (values(i) >= study::DesignObjective::most || slopes.row(i).isZero(0)) continue;
      EXPECT_NEAR(slopes(i, j), quotient(i), differences * largest) << "place " << i << ", parameter " << j;
      ++compared;
    }
  }
  EXPECT_GE(compared, 24);
}

TEST(DesignSlopes, AgreeWithDifferencesUnderLossFactors) {
  for (unsigned seed = 1; seed <= 4; ++seed) expect_slopes_of(machine(seed, "damping = {loss_factor = 0.1}\n"));
}

TEST(DesignSlopes, AgreeWithDifferencesUnderViscousDamping) {
  for (unsigned seed = 5; seed <= 8; ++seed)
    expect_slopes_of(machine(seed, "damping = {translation = [150, 120, 300], rotation = [1, 1, 1]}\n"));
}

TEST(DesignSlopes, AgreeWithDifferencesUnderProportionalDamping) {
  expect_slopes_of(machine(9, "damping = {proportional = 2e-3}\n"));
}

/// Twenty times its weight takes a tenth of the tilting stiffness: forces at rest change with every number.
TEST(DesignSlopes, AgreeWithDifferencesUnderALargeWeight) {
  std::string text = machine(10, "damping = {loss_factor = 0.1}\n");
  text.replace(text.find("-9.80665"), 8, "-196");
  expect_slopes_of(text);
}

TEST(DesignSlopes, AgreeWithDifferencesUnderAThrust) {
  std::string text = machine(11, "stiffening = 1.3\ndamping = {loss_factor = 0.1}\n") +
      "[excitations.thrust]\ntype = \"constant\"\non = \"machine\"\nat = [0.1, 0.2, 0.5]\nforce = [900, 400, 100]\n";
  text.replace(text.find("-9.80665"), 8, "-196");
  text.replace(text.find("static = {"), 10, "static = {\"machine.seat.x\" = \"8 mm\", \"link.force.x\" = 500, ");
  expect_slopes_of(text);
}

/// A mass on a spring: ln of the largest amplitude falls by ln k as −1 without damping, at rest and at resonance.
TEST(DesignSlopes, OfAMassOnASpring) {
  const project::Project project = test::project(
      "trivet = 1\n[bodies.m]\nmass = 10\nfree = [\"z\"]\n[elements.s]\ntype = \"bushing\"\non = \"m\"\nat = [0, 0, "
      "0]\n"
      "translation = [1, 1, 1e5]\ndamping = {loss_factor = 0.1}\n[excitations.f]\ntype = \"harmonic\"\non = \"m\"\nat "
      "= "
      "[0, 0, 0]\nforce = [0, 0, 1]\n[parameters.k]\npath = \"elements.s.scale\"\nfrom = 0.5\nto = 2\nspacing = "
      "\"logarithmic\"\n[requirements]\nlimits = {\"m.z\" = 1}\n");
  const study::DesignObjective objective(project, {});
  Eigen::VectorXd values;
  Eigen::MatrixXd slopes;
  objective.evaluate(Eigen::VectorXd::Constant(1, 0.5), values, &slopes);
  // |y| = F/(η k) at ω² = k/m: the margin grows with k, ln k by ln 4 over the range.
  Eigen::Index least = 0;
  values.minCoeff(&least);
  constexpr double round_off = 1e-9;
  EXPECT_NEAR(values(least), std::log(0.1 * 1e5), round_off);
  EXPECT_NEAR(slopes(least, 0), std::log(4.0), round_off);
}

}  // namespace design_slopes_test
