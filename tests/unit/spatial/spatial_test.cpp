// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numbers>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/spatial/mass_properties.h"
#include "trivet/spatial/rigid_motion.h"

namespace spatial_test {

using namespace trivet;
using namespace trivet::spatial;

constexpr double round_off = 1e-14;         // a few operations on numbers up to 10
constexpr double shift_round_off = 1e-13;   // an inertia shifted to the pole and back
constexpr double energy_round_off = 1e-12;  // a few dozen operations on an energy of about 50 J

TEST(RigidMotion, APointMovesByTranslationPlusRotationCrossArm) {
  const Eigen::Vector3d r(0.3, -0.2, 0.7), u(1, 2, 3), theta(0.1, -0.4, 0.2);
  Vector6 q;
  q << u, theta;
  const Vector6 at_point = rigid_motion(r) * q;
  EXPECT_LE((at_point.head<3>() - (u + theta.cross(r))).norm(), round_off);
  EXPECT_LE((at_point.tail<3>() - theta).norm(), round_off);
}

TEST(RigidMotion, PowerIsTheSameAtEveryPoint) {
  const Eigen::Vector3d r(0.3, -0.2, 0.7), f(4, -1, 2), m(0.5, 1, -3);
  Vector6 wrench, q;
  wrench << f, m;
  q << 1, 2, 3, 0.1, -0.4, 0.2;
  EXPECT_NEAR((rigid_motion(r).transpose() * wrench).dot(q), wrench.dot(rigid_motion(r) * q), round_off);
  EXPECT_LE(((rigid_motion(r).transpose() * wrench).tail<3>() - (m + r.cross(f))).norm(), round_off);
}

TEST(AxesAlong, FollowTheConvention) {
  const Eigen::Matrix3d z = axes_along({0, 0, 2});
  EXPECT_LE((z - Eigen::Matrix3d::Identity()).norm(), round_off);
  const Eigen::Matrix3d x = axes_along({1, 0, 0});  // |e3·x| > 0.9: e1 is the projection of y
  EXPECT_LE((x.col(0) - Eigen::Vector3d::UnitY()).norm(), round_off);
  EXPECT_NEAR(axes_along({1, 2, -3}).determinant(), 1, round_off);
  EXPECT_THROW(static_cast<void>(axes_along({0, 0, 0})), foundation::InvalidInput);
}

TEST(RotationAbout, IsRightHanded) {
  EXPECT_LE(
      (rotation_about({0, 0, 5}, std::numbers::pi / 2) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
      round_off);
}

TEST(MassProperties, AreUnchangedByAShiftToThePoleAndBack) {
  const MassProperties body = test::RandomSystem(3).body("b").mass;
  const MassProperties back = from_inertia_about_pole(body.mass, body.centre, inertia_about_pole(body));
  EXPECT_LE((back.inertia_about_centre - body.inertia_about_centre).norm(),
            shift_round_off * body.inertia_about_centre.norm());
}

TEST(MassMatrix, GivesTheKineticEnergyOfThePoints) {
  // Two points on a light bar: ½ Σ m |v|² against ½ q̇ᵀ A q̇.
  const Eigen::Vector3d p1(0.4, 0.1, -0.2), p2(-0.3, 0.5, 0.6);
  const double m1 = 3, m2 = 5;
  const Eigen::Vector3d centre = (m1 * p1 + m2 * p2) / (m1 + m2);
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (const auto& [m, p] : {std::pair{m1, p1}, {m2, p2}})
    j += m * (p.squaredNorm() * Eigen::Matrix3d::Identity() - p * p.transpose());
  const Matrix6 a = mass_matrix(from_inertia_about_pole(m1 + m2, centre, j));
  Vector6 q;
  q << 0.3, -1, 2, 0.7, -0.2, 0.9;
  const auto velocity = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return q.head<3>() + Eigen::Vector3d(q.tail<3>()).cross(p);
  };
  EXPECT_NEAR(q.dot(a * q), m1 * velocity(p1).squaredNorm() + m2 * velocity(p2).squaredNorm(), energy_round_off);
}

TEST(ViolatedBounds, AreEmptyForARealBodyAndALamina) {
  EXPECT_TRUE(violated_bounds(test::RandomSystem(4).body("b").mass).empty());
  MassProperties lamina{2, {0.1, 0, 0}, Eigen::Vector3d(1, 2, 3).asDiagonal()};  // flat: J3 = J1 + J2 exactly
  EXPECT_TRUE(violated_bounds(lamina).empty());
}

TEST(ViolatedBounds, NameEachBound) {
  MassProperties body{-2, {0, 0, 0}, Eigen::Vector3d(1, 1, 3).asDiagonal()};
  EXPECT_EQ(violated_bounds(body).size(), 2u);  // mass, triangle
  body.mass = 2;
  ASSERT_EQ(violated_bounds(body).size(), 1u);
  EXPECT_THAT(violated_bounds(body)[0].rule, testing::HasSubstr("by 1 kg m²"));
  EXPECT_FALSE(violated_bounds({2, {0, 0, 0}, Eigen::Vector3d(0, 1, 1).asDiagonal()}).empty())
      << "a rod without thickness cannot turn about itself";
}

TEST(Screw, HasTheAxisAndPitchOfARotation) {
  const Eigen::Vector3d axis_point(1, 2, 0), direction(0, 0, 1);
  const Eigen::Vector3d theta = 0.2 * direction, u = -theta.cross(axis_point) + 0.05 * direction;  // pitch 0.25
  const Screw s = screw({u, theta}, 1, {0, 0, 3});
  EXPECT_FALSE(s.pure_translation);
  EXPECT_NEAR(s.pitch, 0.25, round_off);
  EXPECT_LE((s.point - Eigen::Vector3d(1, 2, 3)).norm(), round_off);
  EXPECT_LE((s.direction - direction).norm(), round_off);
}

TEST(Screw, HasTheDirectionOfATranslation) {
  const Screw s = screw({{0, 3, 4}, {1e-14, 0, 0}}, 1, {0, 0, 0});
  EXPECT_TRUE(s.pure_translation);
  EXPECT_NEAR(s.direction.y(), 0.6, round_off);
}

}  // namespace spatial_test
