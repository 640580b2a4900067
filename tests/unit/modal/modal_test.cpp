// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <fmt/format.h>

#include "support/machine_on_deck.h"
#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/modal/free_motions.h"
#include "trivet/modal/roots.h"

namespace modal_test {

using namespace trivet;
using testing::HasSubstr;

constexpr double round_off = 1e-12;       // eigenvectors of up to 8 coordinates, sums over all entries
constexpr double root_round_off = 1e-13;  // eigenvalues of a system of one coordinate

std::string cube(const std::string& elements) {
  return "trivet = 1\n[bodies.cube]\nmass = 6\ninertia = {about = \"center_of_mass\", xx = 1, yy = 1, zz = 1}\n" +
      elements;
}

std::vector<std::string> free_words(const std::string& text) {
  const auto project = test::project(text);
  const auto assembled = assembly::assemble(project.base().system);
  return modal::free_motions(project.base().system, assembled, modal::modes(project.base().system, assembled));
}

TEST(FreeMotions, AreNamed) {
  EXPECT_EQ(free_words(cube("")).size(), 6u);
  const auto slides =
      free_words(cube("[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [10, 0, "
                      "10]\nrotation = [5, 5, 5]\n"));
  ASSERT_EQ(slides.size(), 1u);
  EXPECT_EQ(slides[0], "the system is free to slide along y");
  const auto turns =
      free_words(cube("[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0.5, 0, 0]\ntranslation = [10, 10, "
                      "10]\nrotation = [5, 5, 0]\n"));
  ASSERT_EQ(turns.size(), 1u);
  EXPECT_THAT(turns[0], HasSubstr("free to turn about z through (0.500, 0.000, 0.000)"));
}

TEST(FreeMotions, DistinguishAPartFromTheWhole) {
  const auto words = free_words(test::chain({1, 1}, {100, 0, 0}, {}));
  ASSERT_EQ(words.size(), 1u);
  EXPECT_THAT(words[0], HasSubstr("m2"));
}

TEST(Modes, RepeatedRootsHaveAnOrthonormalBasisAndAreMarked) {
  const auto project =
      test::project(cube("[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [60, 60, "
                         "60]\nrotation = [40, 40, 90]\n"));
  const modal::Modes modes = modal::modes(project.base().system);
  const Eigen::MatrixXd A = assembly::assemble(project.base().system).matrices.A;
  EXPECT_EQ(std::ranges::count_if(modes.list, [](const auto& m) { return m.repeated; }), 5);
  for (const auto& a : modes.list)
    for (const auto& b : modes.list) EXPECT_NEAR(a.shape.dot(A * b.shape), a.number == b.number ? 1 : 0, round_off);
}

TEST(Modes, AreNamedAfterTheirMotion) {
  const auto project =
      test::project(cube("[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [60, 120, "
                         "240]\nrotation = [400, 900, 1600]\n"));
  const modal::Modes modes = modal::modes(project.base().system);
  EXPECT_EQ(modes.list[0].name, "translation along x");
  EXPECT_EQ(modes.list[2].name, "translation along z");
  EXPECT_THAT(modes.list[5].name, HasSubstr("rotation about z through (0.000, 0.000, 0.000)"));
}

TEST(Modes, AreNamedByEnergyForAGuidedBody) {
  const auto project = test::project(R"(
trivet = 1
[bodies.b]
mass = 1000
inertia = {about = "center_of_mass", xx = 0.001, yy = 0.001, zz = 0.001}
free = ["x", "ry"]
[elements.k]
type = "bushing"
on = "b"
at = [0, 0, 0.001]
translation = [1e5, 0, 0]
rotation = [0, 5, 0]
)");
  EXPECT_THAT(modal::modes(project.base().system).list[0].name, HasSubstr("translation along x"));
}

TEST(FreeMotions, AreRotationsOnABushingWithoutRotationalStiffness) {
  const auto words =
      free_words(cube("[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [10, 20, 30]\n"));
  EXPECT_EQ(words.size(), 3u);
  EXPECT_THAT(words[0], HasSubstr("free to turn"));
}

TEST(Roots, FollowTheTextbookForOneMass) {
  const auto roots_of = [](double dashpot) {
    return modal::roots(test::project(test::chain({2}, {1800}, {dashpot})).base().system);
  };
  const modal::Roots light = roots_of(12);  // ζ = 0.1
  ASSERT_EQ(light.list.size(), 2u);
  EXPECT_THAT(*light.list[0].damping_ratio, test::RelativelyNear(0.1, root_round_off));
  EXPECT_THAT(*light.list[0].angular_frequency, test::RelativelyNear(30.0, root_round_off));
  const modal::Roots heavy = roots_of(240);  // ζ = 2
  EXPECT_EQ(heavy.list[0].kind, modal::RootKind::overdamped);
  EXPECT_FALSE(heavy.list[0].angular_frequency.has_value());
  EXPECT_THAT(heavy.list[0].eigenvalue.real(), test::RelativelyNear(-30 * (2 - std::sqrt(3.0)), round_off));
  EXPECT_EQ(roots_of(120).list[0].kind, modal::RootKind::overdamped) << "critical damping does not oscillate";
  const modal::Roots none = roots_of(0);
  EXPECT_EQ(none.list[0].eigenvalue.real(), 0);
  EXPECT_EQ(*none.list[0].damping_ratio, 0);
}

TEST(Roots, CannotGrowIfStiffnessAndDampingTakeEnergy) {
  const auto project = test::project(test::chain({2, 3}, {1800, 700}, {12, 0}));
  const model::System& system = project.base().system;
  assembly::Assembled assembled = assembly::assemble(system);
  modal::Modes modes = modal::modes(system, assembled);
  EXPECT_TRUE(modal::cannot_grow(assembled, modes));
  assembled.matrices.B(1, 1) -= 1;  // a damper that feeds energy
  EXPECT_FALSE(modal::cannot_grow(assembled, modes));
  assembled.matrices.B(1, 1) += 1;
  assembled.matrices.symmetric = false;
  EXPECT_FALSE(modal::cannot_grow(assembled, modes)) << "modes of an unsymmetric system do not prove it";
  assembled.matrices.symmetric = true;
  modes.list[0].eigenvalue_squared = -1;
  EXPECT_FALSE(modal::cannot_grow(assembled, modes));
}

TEST(Roots, LieInThePositiveHalfPlaneForALossFactor) {
  const modal::Roots roots = modal::roots(test::project(test::chain({2}, {1800}, {}, {0.3})).base().system);
  ASSERT_EQ(roots.list.size(), 1u);
  const std::complex<double> expected = std::sqrt(std::complex<double>(-900, -270));
  EXPECT_LE(std::abs(roots.list[0].eigenvalue - (expected.imag() > 0 ? expected : -expected)), root_round_off * 30);
}

TEST(Roots, BelongToTheModeOfTheirShapeNotOfTheirSize) {
  // 10 rad/s along x with the loss factor 0.8 gives |λ| = 10 (1 + 0.8²)^¼ = 11.3 rad/s, above the 11 rad/s along z.
  const std::string text =
      "trivet = 1\n[bodies.b]\nmass = 1\nfree = [\"x\", \"z\"]\ninertia = {about = \"pole\", xx = 1, yy = 1, zz = 1}\n"
      "[elements.x]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\ntranslation = [100, 0, 0]\nrotation = [0, 0, "
      "0]\ndamping = {loss_factor = 0.8}\n"
      "[elements.z]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\ntranslation = [0, 0, 121]\nrotation = [0, 0, 0]\n";
  const modal::Roots roots = modal::roots(test::project(text).base().system);
  ASSERT_EQ(roots.list.size(), 2u);
  EXPECT_NEAR(*roots.list[1].angular_frequency, 10 * std::pow(1.64, 0.25), round_off);
  EXPECT_EQ(roots.list[0].nearest_mode, 2);
  EXPECT_EQ(roots.list[1].nearest_mode, 1);
}

TEST(Roots, BelongToTheModesInOrderForAnUndampedMachineOnADeck) {
  const modal::Roots roots =
      modal::roots(test::project(test::machine_on_deck(
                                     "[foundations.deck]\ntype = \"modal\"\nmodes = [{frequency = 40, modal_mass = "
                                     "5000, damping = 0, shapes = {m1 = [0, 0, 1], m2 = [0, 0, 1], m3 = [0, 0, 1]}}]\n",
                                     ""),
                                 {"elements.m1.damping.proportional=0", "elements.m2.damping.proportional=0",
                                  "elements.m3.damping.proportional=0"})
                       .base()
                       .system);
  int number = 0;
  for (const modal::Root& root : roots.list)
    if (root.eigenvalue.imag() > 0) {
      EXPECT_EQ(root.nearest_mode, ++number);
    }
  EXPECT_EQ(number, 7);
}

TEST(Roots, ADashpotToTheWallLeavesOneDriftAndOneDecay) {
  const modal::Roots roots = modal::roots(
      test::project(test::chain({2, 1}, {0, 100, 0}, {}) +
                    "[elements.d]\ntype = \"damper\"\non = \"m1\"\nat = [0, 0, 0]\naxis = \"x\"\ncoefficient = 5\n")
          .base()
          .system);
  EXPECT_EQ(std::ranges::count_if(roots.list, [](const auto& r) { return r.kind == modal::RootKind::rigid; }), 1);
  EXPECT_EQ(std::ranges::count_if(roots.list, [](const auto& r) { return r.kind == modal::RootKind::overdamped; }), 1);
}

TEST(ModalDamping, GivesTheRequestedRatios) {
  constexpr double through_two_eigensolvers = 1e-10;  // modes give the damping matrix, its roots the ratios
  const std::string text = test::chain({1, 2, 3}, {100, 200, 300, 400}, {});
  const modal::Roots roots = modal::roots(test::project(text + "[damping]\nmodal = [0.01, 0.05, 0.2]\n").base().system);
  ASSERT_EQ(roots.list.size(), 6u);
  for (const auto& [index, ratio] : {std::pair{0u, 0.01}, {2u, 0.05}, {4u, 0.2}})
    EXPECT_THAT(*roots.list[index].damping_ratio, test::RelativelyNear(ratio, through_two_eigensolvers));
}

TEST(RayleighDamping, IsAlphaAPlusBetaK) {
  const auto m = assembly::assemble(test::project(test::chain({1, 2}, {100, 200, 0}, {}) +
                                                  "[damping]\nrayleigh = {mass = 0.3, stiffness = \"2 ms\"}\n")
                                        .base()
                                        .system)
                     .matrices;
  constexpr double few_roundings = 1e-15;  // entries up to 1
  EXPECT_LE((m.B - 0.3 * m.A - 0.002 * m.K).norm(), few_roundings);
}

// A mass on a spring on a floor, [[k, -k], [-k, k + K]] φ = ω² diag(m, M) φ: the spring has k (φ1 - φ2)², the floor K
// φ2².
TEST(Modes, KnowTheStrainEnergyOfFoundations) {
  constexpr double m = 6, M = 5, k = 60, K = 400;
  const std::string mount =
      "[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [60, 60, 60]\n"
      "rotation = [40, 40, 90]\nfoundation = \"floor\"\n";
  const std::string floor_of_400 =  // √(K/M)
      "[foundations.floor]\ntype = \"modal\"\n"
      "modes = [{frequency = 8.94427190999916, modal_mass = 5, shapes = {k = [0, 0, 1]}}]\n";
  const auto project = test::project("trivet = 1\n[bodies.cube]\nmass = 6\nfree = [\"z\"]\n" + mount + floor_of_400);
  const modal::Modes modes = modal::modes(project.base().system);
  ASSERT_EQ(modes.list.size(), 2u);
  for (const modal::Mode& mode : modes.list) {
    const double a = m * M, b = -(m * (k + K) + M * k), c = k * K;
    const double squared = (-b + (mode.number == 1 ? -1 : 1) * std::sqrt(b * b - 4 * a * c)) / (2 * a);
    const double floor = 1 - m * squared / k;  // for a unit motion of the mass
    const double in_spring = k * (1 - floor) * (1 - floor), in_floor = K * floor * floor;
    EXPECT_NEAR(mode.foundation_strain_energy_share, in_floor / (in_spring + in_floor), round_off) << mode.number;
    const auto most = modal::most_strained(mode);
    ASSERT_TRUE(most);
    EXPECT_EQ(most->in_foundations, mode.number == 2);
    EXPECT_NEAR(most->share, std::max(in_floor, in_spring) / (in_spring + in_floor), round_off);
  }
}

// λ² m u + (λ c + k)(u − w) = 0 of the mass, whatever the floor is: its motion w follows from that of the mass.
TEST(Roots, StateTheMotionOfFoundationsThatBalancesTheMass) {
  constexpr double m = 6, k = 60, c = 7;
  const auto project = test::project(
      "trivet = 1\n[bodies.cube]\nmass = 6\nfree = [\"z\"]\n"
      "[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [60, 60, 60]\n"
      "rotation = [40, 40, 90]\ndamping = {translation = [7, 7, 7]}\nfoundation = \"floor\"\n"
      "[foundations.floor]\ntype = \"modal\"\n"
      "modes = [{frequency = 9, modal_mass = 5, damping = 0.2, shapes = {k = [0, 0, 1]}}]\n");
  const modal::Roots roots = modal::roots(project.base().system);
  ASSERT_EQ(roots.list.size(), 4u);
  for (const modal::Root& root : roots.list) {
    const std::complex<double> force = root.eigenvalue * c + k,
                               floor = root.shape(2) * (m * root.eigenvalue * root.eigenvalue / force + 1.0);
    ASSERT_EQ(root.feet.cols(), 1);
    // the floor is not in phase with the mass
    EXPECT_GT(std::abs((floor / root.shape(2)).imag()), 0.01) << root.eigenvalue;
    EXPECT_LE(std::abs(root.feet(2, 0) - floor), round_off) << root.eigenvalue;
    EXPECT_EQ(root.feet.col(0).head<2>().norm() + root.feet.col(0).tail<3>().norm(), 0);
  }
}

TEST(Modes, HaveNoStrainSharesIfAFoundationMovesNoMount) {
  const auto project =
      test::project(cube("[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [60, 60, "
                         "60]\nrotation = [40, 40, 90]\nfoundation = \"deck\"\n"
                         "[foundations.deck]\ntype = \"modal\"\nmodes = [{frequency = 3, modal_mass = 5, shapes = {k = "
                         "[0, 0, 0]}}, {frequency = 7, modal_mass = 5, shapes = {k = [0, 0, 1]}}]\n"));
  const modal::Modes modes = modal::modes(project.base().system);
  ASSERT_EQ(modes.list.size(), 8u);
  int without = 0;
  for (const modal::Mode& mode : modes.list) {
    if (!mode.strain_energy_share) ++without;
    else EXPECT_NEAR(mode.strain_energy_share->sum(), 1, round_off) << mode.number;
  }
  EXPECT_EQ(without, 1);
  for (const modal::Mode& mode : modes.list)
    if (!mode.strain_energy_share) {
      EXPECT_TRUE(modal::most_strained(mode)->in_foundations);
    }
}

}  // namespace modal_test
