// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/beam.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <random>

#include "support/matchers.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/rubber_mounts.h"
#include "trivet/foundation/invalid_input.h"

namespace beam_test {

using namespace trivet;
using namespace trivet::elements;

const Metal steel = metal("structural_steel").value();

constexpr double round_off = 1e-12;         // a hundred operations on entries of equal scaled size
constexpr double series_round_off = 1e-11;  // three inversions of 6 × 6 matrices
constexpr double few_roundings = 1e-14;     // products in another order

Beam random_beam(std::mt19937& engine) {
  std::uniform_real_distribution<> random(0.2, 1);
  const double width = 0.1 * random(engine), depth = 0.1 * random(engine);
  return {steel, rectangular_section(width, depth, steel), 2 * random(engine)};
}

TEST(Beam, ResistsNoRigidMotion) {
  std::mt19937 engine(3);
  for (int round = 0; round < 100; ++round) {
    const Beam beam = random_beam(engine);
    const MatrixVerdict verdict =
        examine(beam_stiffness(beam), rigid_motions({0, 0, beam.length}, Eigen::Matrix3d::Identity()));
    EXPECT_LE(verdict.rigid_residual, round_off);
    EXPECT_LE(verdict.asymmetry, round_off);
    EXPECT_TRUE(is_semidefinite(verdict));
  }
}

TEST(Beam, TheMassMatrixHasTheInertiaOfTheRigidBeam) {
  std::mt19937 engine(4);
  for (int round = 0; round < 20; ++round) {
    const Beam b = random_beam(engine);
    const auto g = rigid_motions({0, 0, b.length}, Eigen::Matrix3d::Identity());
    const Matrix6 inertia = g.transpose() * beam_mass(b) * g;  // about K
    const double line = b.metal.density * b.section.area, mass = line * b.length;
    for (int i = 0; i < 3; ++i) EXPECT_THAT(inertia(i, i), test::RelativelyNear(mass, round_off));
    EXPECT_THAT(inertia(3, 3),
                test::RelativelyNear(line * std::pow(b.length, 3) / 3 + b.metal.density * b.section.moment_1 * b.length,
                                     round_off));
    EXPECT_THAT(inertia(4, 4),
                test::RelativelyNear(line * std::pow(b.length, 3) / 3 + b.metal.density * b.section.moment_2 * b.length,
                                     round_off));
    EXPECT_THAT(
        inertia(5, 5),
        test::RelativelyNear(b.metal.density * (b.section.moment_1 + b.section.moment_2) * b.length, round_off));
    EXPECT_THAT(inertia(4, 0), test::RelativelyNear(-mass * b.length / 2, round_off));
    EXPECT_TRUE(beam_mass(b).isApprox(beam_mass(b).transpose(), few_roundings));
  }
}

TEST(Beam, TwoPartsInSeriesEqualTheWhole) {
  std::mt19937 engine(5);
  for (int round = 0; round < 20; ++round) {
    const Beam whole = random_beam(engine);
    Beam part = whole;
    part.length = whole.length / 3;
    Beam rest = whole;
    rest.length = whole.length - part.length;
    const Matrix12 joined =
        in_series({{beam_stiffness(part), {0, 0, part.length}}, {beam_stiffness(rest), {0, 0, rest.length}}},
                  {Eigen::Vector3d::Zero()});
    const spatial::Vector12 scale = beam_stiffness(whole).diagonal().cwiseSqrt();
    EXPECT_THAT(joined, test::NearInUnits(beam_stiffness(whole), scale, series_round_off));
  }
}

TEST(Link, PullsAlongItsAxisOnly) {
  const Matrix12 k = link_stiffness({.axial_stiffness = 1e7, .length = 0.4});
  constexpr double one_rounding = 1e-15;  // each row has two entries, equal and opposite
  EXPECT_LE(examine(k, rigid_motions({0, 0, 0.4}, Eigen::Matrix3d::Identity())).rigid_residual, one_rounding);
  EXPECT_EQ(k(8, 8), 1e7);
  EXPECT_EQ((k.array() != 0).count(), 4);
}

TEST(Link, UnderTensionTurnsItsPreload) {
  const Link link{.axial_stiffness = 1e7, .length = 0.4, .tension = 800};
  const auto g = rigid_motions({0, 0, link.length}, Eigen::Matrix3d::Identity());
  const Eigen::Matrix<double, 12, 6> forces = link_stiffness(link) * g;
  constexpr double no_force = 1e-12;         // [N/m] the entries of a row, 2000 or 1e7 N/m, are equal and opposite
  constexpr double force_round_off = 1e-10;  // [N] a few roundings of 800 N
  EXPECT_LE(forces.leftCols<3>().norm(), no_force);
  const spatial::Vector12 preload = link_preload(link);
  for (int end = 0; end < 2; ++end)
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d before = preload.segment<3>(6 * end), turned = Eigen::Vector3d::Unit(axis).cross(before);
      EXPECT_LE((forces.col(3 + axis).segment<3>(6 * end) - turned).norm(), force_round_off);
    }
}

TEST(BeamChecks, NameEveryBadNumber) {
  EXPECT_TRUE(check(Beam{steel, round_section(0.03, steel), 0.5}).list().empty());
  EXPECT_EQ(check(Beam{steel, round_section(0.03, steel), 0.05}).list().front().severity,
            foundation::Severity::warning);
  EXPECT_TRUE(check(Beam{steel, Section{}, 0.5}).has_errors());
  EXPECT_TRUE(check(Link{.axial_stiffness = -1, .length = 0, .tension = std::nan("")}).list().size() == 3);
  EXPECT_THROW((void)beam_stiffness({steel, round_section(0.03, steel), -0.5}), foundation::InvalidInput);
}

}  // namespace beam_test
