// SPDX-License-Identifier: BSD-3-Clause
// Solid mounts against closed forms and published numbers.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "trivet/elements/law.h"
#include "trivet/fem/preload.h"
#include "trivet/fem/shapes.h"
#include "trivet/spatial/rigid_motion.h"

namespace solid_mount_test {

using namespace trivet;
using std::numbers::pi;
using test::RelativelyNear;

/// Cylinder 50 mm × 25 mm, E = 3 MPa, ν = 0.4995, bonded at both ends. Converged values of graded hexahedra, tetrahedra
/// with either kind of pressure, and two other programs: 363.45 kN/m, 68.55 kN/m, 59.06 N m/rad about the top plate.
const fem::Disc cylinder{.diameter = 0.05, .layers = {{.thickness = 0.025}}};
const fem::Material rubber = fem::linear_elastic(3e6, 0.4995);
constexpr double axial = 363.45e3, shear = 68.55e3, tilt = 59.06;
constexpr double solve_round_off = 1e-9;  // condensations of some thousand equations

TEST(BondedCylinder, HasTheConvergedStiffnessesAtTheDefaultLevel) {
  constexpr double goal = 0.0015, of_use = 0.01;  // accuracy of the default level, and of an estimate of it
  const fem::SolidStiffness solid = fem::condense(cylinder, {rubber});
  const auto& c = solid.stiffness;
  EXPECT_THAT(c(8, 8), RelativelyNear(axial, goal));
  EXPECT_THAT(c(6, 6), RelativelyNear(shear, goal));
  EXPECT_THAT(c(7, 7), RelativelyNear(c(6, 6), solve_round_off));  // the nodes of the mesh are joined correctly
  EXPECT_THAT(c(9, 9), RelativelyNear(tilt, goal));
  for (const int i : {6, 8, 9}) {
    const double error = std::abs(c(i, i) / (i == 6 ? shear : i == 8 ? axial : tilt) - 1);
    EXPECT_LT(error, solid.relative_error(i, i)) << "the estimate is cautious";
    EXPECT_LT(solid.relative_error(i, i), of_use) << "and of use";
  }
}

TEST(BondedCylinder, ConvergesWithinItsEstimateOnFinerLevels) {
  constexpr double printed_digits = 0.005 / 68.55;  // of the reference
  for (const int level : {2, 4}) {
    const fem::SolidStiffness solid = fem::condense(cylinder, {rubber}, level);
    EXPECT_LT(std::abs(solid.stiffness(8, 8) / axial - 1), solid.relative_error(8, 8) + printed_digits);
    EXPECT_LT(std::abs(solid.stiffness(6, 6) / shear - 1), solid.relative_error(6, 6) + printed_digits);
  }
}

TEST(BondedCylinder, TwistsLikeSaintVenantsBar) {
  // G J/H is exact for bonded ends; the circle is approximated by parabolic arcs, an error of at least fourth order.
  constexpr double circle = 1e-6;
  const double exact = fem::shear_modulus(rubber) * pi * std::pow(0.025, 4) / 2 / 0.025;
  EXPECT_THAT(fem::condense(fem::mesh(cylinder, 2), {rubber}, fem::frame(cylinder)).stiffness(11, 11),
              RelativelyNear(exact, circle));
}

TEST(BondedCylinder, DoesNotLockNearIncompressibility) {
  // Between ν = 0.4999 and 0.49999 the material changes by 3e-5 in G and little in volume at this shape factor.
  constexpr double change = 1e-3;
  double before = 0;
  for (const double nu : {0.4999, 0.49999}) {
    const double now =
        fem::condense(fem::mesh(cylinder, 2), {fem::linear_elastic(3e6, nu)}, fem::frame(cylinder)).stiffness(8, 8);
    if (before > 0) {
      EXPECT_THAT(now, RelativelyNear(before, change));
    }
    before = now;
  }
}

double bessel(int order, double x) {
  double term = std::pow(x / 2, order) / std::tgamma(order + 1), sum = 0;
  for (int k = 1; k < 60; ++k) {
    sum += term;
    term *= x * x / 4 / (k * (k + order));
  }
  return sum;
}

/// Apparent moduli of a bonded disc by the pressure equation with bulk modulus (Chalhoub and Kelly): λ = S √(48 G/κ),
/// E_c = κ (1 − 2 I1/(λ I0)), E_b = κ (1 − 4 I2/(λ I1)).
struct PressureSolution {
  double compression, bending;
};
PressureSolution pressure_solution(double shape_factor, double g, double bulk) {
  const double l = shape_factor * std::sqrt(48 * g / bulk);
  return {bulk * (1 - 2 * bessel(1, l) / (l * bessel(0, l))), bulk * (1 - 4 * bessel(2, l) / (l * bessel(1, l)))};
}

TEST(BondedDisc, FollowsThePressureSolutionOverAllShapeFactors) {
  // R = 50 mm, G = 0.7 MPa, κ = 2 GPa. The pressure solution neglects the stress of free stretching; E0 = 3G is added
  // for it. The rest is due to the free edge: 6 % was found at S = 0.25, and it decreases like 1/S for thin discs.
  constexpr double radius = 0.05, g = 0.7e6, bulk = 2e9, edge = 0.08, mesh_error = 0.006;
  constexpr double all_digits = 1e-9;  // of the moduli of a separate program
  constexpr double circle = 1e-6;      // parabolic arcs, see above
  constexpr double thin_disc = 0.01;   // edge and mesh at S ≥ 10, without 3G
  EXPECT_THAT(pressure_solution(1.25, g, bulk).compression, RelativelyNear(6533918.01350156, all_digits));
  EXPECT_THAT(pressure_solution(1.25, g, bulk).bending, RelativelyNear(2183917.4021871523, all_digits));
  for (const double s : {0.25, 0.5, 1.25, 2.5, 5.0, 10.0, 20.0}) {
    const double h = radius / (2 * s);
    const fem::Disc disc{.diameter = 2 * radius, .layers = {{.thickness = h}}};
    const auto c = fem::condense(fem::mesh(disc, 2), {fem::neo_hookean(g, bulk)}, fem::frame(disc)).stiffness;
    const double fading = edge / std::max(1.0, s) + mesh_error, area = pi * radius * radius;
    EXPECT_THAT(c(8, 8) * h / area, RelativelyNear(pressure_solution(s, g, bulk).compression + 3 * g, fading))
        << "S = " << s;
    EXPECT_THAT(c(11, 11) * h, RelativelyNear(g * pi * std::pow(radius, 4) / 2, circle)) << "S = " << s;
    if (s >= 2.5) {
      EXPECT_THAT(c(6, 6) * h, RelativelyNear(g * area, fading)) << "S = " << s;
    }
    if (s >= 10) {
      const double bending = (c(9, 9) - c(6, 6) * h * h / 4) * h / (pi * std::pow(radius, 4) / 4);
      EXPECT_THAT(bending, RelativelyNear(pressure_solution(s, g, bulk).bending, thin_disc)) << "S = " << s;
    }
  }
}

TEST(Bush, TwistsExactlyAndShearsAlongItsAxisAsALongOne) {
  // 24 mm × 60 mm, G = 0.7 MPa: 2π G L/ln(r_o/r_i) per length in the middle of a long bush; its free ends are softer
  // over about one wall thickness. 4π G L/(1/r_i² − 1/r_o²) in torsion for any length. Payne and Scott.
  constexpr double g = 0.7e6, inner = 0.012, outer = 0.03, mesh_error = 5e-4;
  constexpr double softer_ends = 0.25;  // of one wall thickness of a long bush, at most
  constexpr double of_the_ends = 0.1;   // a difference of two larger numbers
  double short_axial = 0;
  for (const double length : {0.05, 0.2, 0.35}) {
    const fem::Bush bush{.inner_diameter = 2 * inner, .outer_diameter = 2 * outer, .length = length};
    const auto c = fem::condense(fem::mesh(bush, 2), {fem::neo_hookean(g, 2e9)}, fem::frame(bush)).stiffness;
    EXPECT_THAT(c(11, 11), RelativelyNear(75.39822368615503 * length / 0.05, mesh_error));
    const double missing = 2 * pi * g * length / std::log(outer / inner) - c(8, 8);
    const double of_one_wall = 240001.8663306621 / 0.05 * (outer - inner);
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, softer_ends * of_one_wall);
    if (length > 0.1 && short_axial > 0) {
      EXPECT_THAT(missing, RelativelyNear(short_axial, of_the_ends)) << "the ends do not know of the length";
    }
    short_axial = length > 0.1 ? missing : 0;
  }
}

TEST(Sandwich, ThreeLayersAreInSeries) {
  // Steel plates of 2 mm bend little: 0.1 % in compression.
  constexpr double plates_bend = 2e-3, plates_twist = 1e-5;  // G of the rubber over G of steel is 1e-5
  const fem::Disc three{.diameter = 0.1, .layers = fem::sandwich_layers(3, 0.01, 0.002)},
      one{.diameter = 0.1, .layers = {{.thickness = 0.01}}};
  const std::vector<fem::Material> materials{fem::neo_hookean(0.7e6, 2e9), fem::linear_elastic(2.1e11, 0.3)};
  const auto stack = fem::condense(fem::mesh(three, 1), materials, fem::frame(three)).stiffness;
  const auto layer = fem::condense(fem::mesh(one, 1), materials, fem::frame(one)).stiffness;
  EXPECT_THAT(3 * stack(8, 8), RelativelyNear(layer(8, 8), plates_bend));
  EXPECT_THAT(3 * stack(11, 11), RelativelyNear(layer(11, 11), plates_twist));
}

TEST(Preload, FifteenPercentCompressionSoftensShearAndStiffensTheRest) {
  // Given to us as −19 %, +36 %, +43 %, +17 %; torsion of the barrel is near G J/(0.85 H) = 28.9 N m/rad.
  constexpr double two_units_of_the_percentage = 0.02;
  constexpr double of_a_finer_mesh = 12;  // N
  constexpr double last_digit = 1e-15;    // m: one difference
  const fem::Mesh mesh = fem::mesh(cylinder, 2);
  const auto before = fem::condense(mesh, {rubber}, fem::frame(cylinder)).stiffness;
  fem::Preload load;
  load.value(2) = -0.15 * 0.025;
  const fem::PreloadedStiffness solid = fem::preloaded_stiffness(mesh, {rubber}, fem::frame(cylinder), load);
  ASSERT_TRUE(solid.converged) << solid.failure_reason;
  const std::array<std::pair<int, double>, 4> changes{{{6, -0.19}, {8, 0.36}, {9, 0.43}, {11, 0.17}}};
  for (const auto& [i, change] : changes)
    EXPECT_NEAR(solid.stiffness(i, i) / before(i, i) - 1, change, two_units_of_the_percentage) << i;
  EXPECT_NEAR(solid.preload(2), 1598.58, of_a_finer_mesh);
  EXPECT_NEAR(solid.arm.z(), 0.85 * 0.025, last_digit);
  EXPECT_EQ(solid.negative_eigenvalues, 0);
}

TEST(Preload, TurnsWithTheElementAsAPotentialDemands) {
  // K G is zero for a translation; a rotation φ turns the forces (φ × F) and, for rotation vectors, half the moments
  // (½ φ × M).
  constexpr double balance = 1e-7;  // of Newton's method, relative to preload 1e-9, amplified by the volume stiffness
  constexpr double newton_force = 1e-5;  // N: 1e-9 of the preload, with room
  constexpr double prescribed = 1e-12;   // m: a motion that is set, not solved for
  constexpr double symmetry = 1e-6;      // N/m: round-off of sums of 1e6 N/m
  const fem::Mesh mesh = fem::mesh(cylinder, 1);
  fem::ElementFrame skew = fem::frame(cylinder);
  skew.axes = spatial::rotation_about(Eigen::Vector3d(1, -1, 2), 0.6);
  fem::Preload load;
  load.value << 120, 0.0004, -900, 0.03, 0.4, 0.02;
  load.is_load = {true, false, true, false, true, false};
  const fem::PreloadedStiffness solid = fem::preloaded_stiffness(mesh, {rubber}, skew, load);
  ASSERT_TRUE(solid.converged) << solid.failure_reason;
  for (const int i : {0, 2, 4})
    EXPECT_NEAR(solid.preload(6 + i), load.value(i), newton_force) << "end K carries the load";
  EXPECT_NEAR(solid.motion(1), 0.0004, prescribed);
  const Eigen::Matrix<double, 12, 6> wrench =
      solid.stiffness * elements::rigid_motions(solid.arm, Eigen::Matrix3d::Identity());
  Eigen::Matrix<double, 12, 6> expected = Eigen::Matrix<double, 12, 6>::Zero();
  for (const int end : {0, 6}) {
    expected.block<3, 3>(end, 3) = -spatial::cross_matrix(solid.preload.segment<3>(end));
    expected.block<3, 3>(end + 3, 3) = -0.5 * spatial::cross_matrix(solid.preload.segment<3>(end + 3));
  }
  const spatial::Vector12 scale = solid.stiffness.diagonal().cwiseSqrt();
  EXPECT_THAT(wrench, test::NearInUnits(expected, scale, balance));
  EXPECT_LT((solid.stiffness - solid.stiffness.transpose()).cwiseAbs().maxCoeff(), symmetry);
}

TEST(Preload, ZeroPreloadIsTheStressFreeElement) {
  const fem::Mesh mesh = fem::mesh(cylinder, 1);
  const auto solid = fem::preloaded_stiffness(mesh, {rubber}, fem::frame(cylinder), {});
  ASSERT_TRUE(solid.converged) << solid.failure_reason;
  const auto free = fem::condense(mesh, {rubber}, fem::frame(cylinder)).stiffness;
  const spatial::Vector12 scale = free.diagonal().cwiseSqrt();
  EXPECT_THAT(solid.stiffness, test::NearInUnits(free, scale, solve_round_off));
}

TEST(Preload, AnImpossibleOneIsRejectedWithTheLastEquilibrium) {
  fem::Preload load;
  load.value(2) = -0.0255;  // through the other plate
  const auto solid = fem::preloaded_stiffness(fem::mesh(cylinder, 1), {rubber}, fem::frame(cylinder), load);
  EXPECT_FALSE(solid.converged);
  EXPECT_LT(solid.reached, 1);
  EXPECT_THAT(solid.failure_reason, testing::HasSubstr("no equilibrium beyond"));
}

}  // namespace solid_mount_test
