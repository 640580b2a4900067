// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/stiffness_properties.h"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/elements/checks.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/spatial/rigid_motion.h"

namespace stiffness_properties_test {

using namespace trivet;
using namespace trivet::elements;

const Eigen::Vector3d arm(0, 0, 0.2);
const Vector6 constants = (Vector6() << 2e5, 3e5, 9e5, 40, 60, 25).finished();
constexpr double round_off = 1e-11;           // some hundred operations, scaled entries near 1
constexpr double few_roundings = 1e-13;       // a dozen operations per scaled entry
constexpr double round_off_at_centre = 1e-9;  // 25 N m/rad remain at the centre of up to 12 000 at K

/// The stiffness in turned element axes: R K Rᵀ at both ends.
Matrix12 turned(const Matrix12& stiffness, const Eigen::Matrix3d& r) {
  Matrix12 turn = Matrix12::Zero();
  turn << spatial::both_blocks(r), Matrix6::Zero(), Matrix6::Zero(), spatial::both_blocks(r);
  return turn * stiffness * turn.transpose();
}

TEST(StiffnessProperties, SpringsThroughAPointShowThatPoint) {
  for (const double centre : {0.0, 0.3, 0.5, 1.0}) {
    const StiffnessProperties c = stiffness_properties(constants_at_point(constants, arm, centre));
    EXPECT_LE((c.elastic_centre - (centre - 1) * arm).norm(), round_off);
    EXPECT_THAT(c.principal_stiffnesses, test::NearVector(Eigen::Vector3d(2e5, 3e5, 9e5), round_off));
    EXPECT_THAT(c.principal_rotational_stiffnesses, test::NearVector(Eigen::Vector3d(25, 40, 60), round_off_at_centre));
    EXPECT_LE(c.coupling_at_centre, round_off_at_centre);
    EXPECT_TRUE(c.centre_is_unique);
  }
}

TEST(StiffnessProperties, TurnsWithTheElement) {
  const Eigen::Matrix3d r = spatial::rotation_about(Eigen::Vector3d(1, -2, 0.5), 0.8);
  const Matrix12 skew = from_moved_end(test::RandomSystem(8).stiffness(1e5, 0.3), arm);
  const StiffnessProperties straight = stiffness_properties(skew), turn = stiffness_properties(turned(skew, r));
  EXPECT_LE((turn.elastic_centre - r * straight.elastic_centre).norm(), round_off);
  EXPECT_THAT(turn.principal_stiffnesses, test::NearVector(straight.principal_stiffnesses, round_off));
  EXPECT_NEAR(turn.coupling_at_centre, straight.coupling_at_centre, round_off_at_centre);
  EXPECT_NEAR(turn.principal_axes.determinant(), 1, round_off);
}

TEST(StiffnessProperties, CouplingIsSymmetricAtTheElasticCentre) {
  const Matrix12 skew = from_moved_end(test::RandomSystem(3).stiffness(1e5, 0.3), arm);
  const Matrix6 motion = spatial::rigid_motion(-stiffness_properties(skew).elastic_centre);
  const Matrix6 there = motion.transpose() * skew.bottomRightCorner<6, 6>() * motion;
  const Eigen::Matrix3d coupling = there.topRightCorner<3, 3>();
  EXPECT_LE((coupling - coupling.transpose()).norm(), round_off_at_centre * there.norm());
}

TEST(StiffnessProperties, ACantileverHasItsKnownCoupling) {
  const double bending = 1e3,
               length = 0.2;  // EI [N m²]: K = 12 EI/l³, −6 EI/l², 4 EI/l, coupling 6/√48, centre at half length
  Matrix6 k = Matrix6::Identity();
  k(2, 2) = 1e7;
  k(0, 0) = k(1, 1) = 12 * bending / (length * length * length);
  k(3, 3) = k(4, 4) = 4 * bending / length;
  k(0, 4) = k(4, 0) = -6 * bending / (length * length);
  k(1, 3) = k(3, 1) = 6 * bending / (length * length);
  const StiffnessProperties c = stiffness_properties(from_moved_end(k, arm));
  EXPECT_NEAR(c.coupling_at_k, 6 / std::sqrt(48.0), round_off);
  EXPECT_LE(c.coupling_at_centre, round_off_at_centre);
  EXPECT_LE((c.elastic_centre - Eigen::Vector3d(0, 0, -length / 2)).norm(), round_off);
  EXPECT_NEAR(c.softest_combination, 1 - 6 / std::sqrt(48.0), round_off);
  EXPECT_NEAR(c.stiffest_combination, 1 + 6 / std::sqrt(48.0), round_off);
}

TEST(StiffnessProperties, AStrutHasALineOfCentres) {
  const StiffnessProperties c = stiffness_properties(constant_along_line(1e5, Eigen::Vector3d::UnitZ(), arm, 0.5));
  EXPECT_FALSE(c.centre_is_unique);
  EXPECT_LE(c.elastic_centre.norm(), round_off);
  EXPECT_EQ(stiffness_properties(Matrix12::Zero()).principal_stiffnesses.norm(), 0);
  EXPECT_THROW((void)stiffness_properties(Matrix12::Constant(std::nan(""))), foundation::InvalidInput);
}

TEST(EnergyShares, SumToOneAndFindTheCoupling) {
  const Matrix12 mount = constants_at_point(constants, arm, 0.5);
  const EnergyShares pure = energy_shares(mount, Vector6::Unit(0));
  EXPECT_EQ(pure.translation, 1);
  EXPECT_EQ(pure.energy, 1e5);
  const EnergyShares mixed = energy_shares(mount, (Vector6() << 1e-3, 0, 0, 0, 1e-2, 0).finished());
  EXPECT_NEAR(mixed.translation + mixed.rotation + mixed.coupling, 1, round_off);
  EXPECT_LT(mixed.coupling, -0.1);  // the rotation takes energy out of the translation
  EXPECT_EQ(energy_shares(mount, Vector6::Zero()).energy, 0);
}

TEST(ThreeSprings, KeepTheTranslationsOfKOnly) {
  const Matrix12 springs = three_springs(from_moved_end(test::RandomSystem(8).stiffness(1e5, 0.3), arm), arm);
  EXPECT_LE(examine(springs, rigid_motions(arm, Eigen::Matrix3d::Identity())).rigid_residual, few_roundings);
  EXPECT_EQ((springs.bottomRightCorner<3, 3>().norm()), 0);
  EXPECT_GT(springs(6, 6), 0);
}

}  // namespace stiffness_properties_test
