// SPDX-License-Identifier: BSD-3-Clause
// Suspension numbers of a block on four mounts in closed form, and a torque roll axis from the literature.
#include "trivet/modal/suspension.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/spatial/rigid_motion.h"

namespace suspension_test {

using namespace trivet;
using test::RelativelyNear;
constexpr double round_off = 1e-12;         // some hundred operations
constexpr double modes_round_off = 1e-10;   // frequencies of six coordinates
constexpr double coupled_round_off = 1e-9;  // shares from a difference of 2e6 and λm
constexpr double skew_round_off = 1e-10;    // solves with a full stiffness

modal::BodySuspension of_body(const model::System& system, std::size_t body = 0) {
  return modal::body_suspension(system, assembly::assemble(system), body);
}

/// Harris, Shock and Vibration Handbook, ch. 3: a body with two planes of symmetry on four mounts below its centre of
/// mass; its pole is at `pole` from the centre of mass.
std::string four_mounts(const Eigen::Vector3d& pole = Eigen::Vector3d::Zero(), const std::string& more = "") {
  const auto from_pole = [&](double x, double y, double z) {
    return fmt::format("[{}, {}, {}]", x - pole.x(), y - pole.y(), z - pole.z());
  };
  std::string text = "trivet = 1\n[bodies.block]\nmass = 1000\ncenter_of_mass = " + from_pole(0, 0, 0) +
      "\ninertia = {about = \"center_of_mass\", xx = 180, yy = 390, zz = 450}\n" + more;
  int number = 0;
  for (const double x : {0.8, -0.8})
    for (const double y : {0.5, -0.5})
      text += fmt::format(
          "[elements.m{}]\ntype = \"three_springs\"\non = \"block\"\nat = {}\ntranslation = [4e5, 5e5, 8e5]\n",
          ++number, from_pole(x, y, -0.4));
  return text;
}

TEST(SuspensionOfABlockOnFourMounts, HasItsElasticCentreInTheMiddleOfTheMounts) {
  for (const Eigen::Vector3d& pole : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.3, -0.2, 0.7)}) {
    const auto project = test::project(four_mounts(pole));
    const modal::BodySuspension suspension = of_body(project.base().system);
    ASSERT_TRUE(suspension.elastic.has_value());
    EXPECT_LE((suspension.elastic->elastic_centre - (Eigen::Vector3d(0, 0, -0.4) - pole)).norm(), round_off);
    EXPECT_LE(suspension.elastic->coupling_at_centre, round_off);
    EXPECT_THAT(suspension.centre_distance, RelativelyNear(0.4, round_off));
    // Sums of k_i and of k_z y² …: all mounts are in the plane of the elastic centre.
    EXPECT_THAT(suspension.elastic->principal_stiffnesses,
                test::NearVector(Eigen::Vector3d(1.6e6, 2e6, 3.2e6), round_off));
    EXPECT_THAT(
        suspension.elastic->principal_rotational_stiffnesses,
        test::NearVector(Eigen::Vector3d(4 * 8e5 * 0.25, 4 * (4e5 * 0.25 + 5e5 * 0.64), 4 * 8e5 * 0.64), round_off));
  }
}

TEST(SuspensionOfABlockOnFourMounts, TurnsAboutLinesThroughItsElasticCentre) {
  const auto project = test::project(four_mounts({0.3, -0.2, 0.7}));
  const modal::BodySuspension suspension = of_body(project.base().system);
  const Eigen::Vector3d torsional(4 * 8e5 * 0.25, 4 * 8e5 * 0.64, 4 * (4e5 * 0.25 + 5e5 * 0.64));
  ASSERT_EQ(suspension.roll_axes.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const modal::RollAxes& axes = suspension.roll_axes[i];
    EXPECT_THAT(axes.torsional_stiffness, RelativelyNear(torsional(i), round_off));
    EXPECT_NEAR(axes.angle, 0, round_off) << "principal axes";
    EXPECT_NEAR(axes.distance_at_centre, i < 2 ? 0.4 : 0, round_off);
    EXPECT_NEAR(axes.shortest_distance, i < 2 ? 0.4 : 0, round_off);
    EXPECT_NEAR(axes.elastic_roll_axis.pitch, 0, round_off);
  }
}

TEST(SuspensionOfABlockOnFourMounts, HasThePublishedFrequenciesAndTwoPureModes) {
  // Closed-form biquadratics; the vertical and the yaw mode are uncoupled.
  constexpr std::array<double, 6> frequencies_hz = {5.695217703488748, 5.887912913343855,  9.003163161571061,
                                                    9.724527652599994, 12.470146321689391, 13.26030984710917};
  const auto project = test::project(four_mounts({0.3, -0.2, 0.7}));
  const modal::BodySuspension suspension = of_body(project.base().system);
  ASSERT_EQ(suspension.modes.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const modal::BodyMode& mode = suspension.modes[i];
    EXPECT_THAT(*mode.angular_frequency / (2 * std::numbers::pi), RelativelyNear(frequencies_hz[i], modes_round_off));
    EXPECT_THAT(mode.kinetic_energy_share.sum(), RelativelyNear(1.0, round_off));
  }
  EXPECT_EQ(suspension.modes[2].purest, 2);
  EXPECT_THAT(suspension.modes[2].decoupling(), RelativelyNear(1.0, round_off));
  EXPECT_EQ(suspension.modes[3].purest, 5);
  EXPECT_THAT(suspension.modes[3].decoupling(), RelativelyNear(1.0, round_off));
  // Of the pair of y and roll: with λ = ω², (K_y − λm) y + K_yθ θ = 0, K_yθ = 0.4 K_y about the centre of mass.
  const double lambda = std::pow(2 * std::numbers::pi * frequencies_hz[0], 2),
               y_over_theta = -0.4 * 2e6 / (2e6 - lambda * 1000);
  EXPECT_THAT(suspension.modes[0].decoupling(),
              RelativelyNear(1000 * y_over_theta * y_over_theta / (1000 * y_over_theta * y_over_theta + 180),
                             coupled_round_off));
}

TEST(TorqueRollAxis, IsThePublishedOneOfAPowertrain) {
  // T. Jeong, R. Singh, Analytical methods of decoupling the automotive engine torque roll axis, J. Sound Vib. 234
  // (2000) 85-114, as quoted at eng-tips.com (thread 71-351229): moments in kg m² and direction to six digits. The
  // quotation does not state the sign convention of the products; of the four that a rotation of axes allows, the one
  // used here gives the direction.
  auto project = test::project(
      "trivet = 1\n[bodies.engine]\nmass = 73.2\ncenter_of_mass = [0.1, 0.2, 0.3]\n"
      "inertia = {about = \"center_of_mass\", xx = 2.519, yy = 4.458, zz = 4.409, xy = 0.1678, xz = 0.5385, yz = "
      "-0.0947}\n"
      "[elements.all]\ntype = \"bushing\"\non = \"engine\"\nat = [0, 0, 0]\ntranslation = [1e5, 1e5, 1e5]\nrotation = "
      "[1e3, 1e3, 1e3]\n");
  const modal::BodySuspension suspension = of_body(project.base().system);
  const Eigen::Vector3d printed(0.992113, 0.0347851, 0.120426);
  constexpr double printed_digits = 5e-6;       // of moments of four digits
  constexpr double digits_of_the_angle = 1e-4;  // an inverse cosine near 1 loses two of six
  EXPECT_THAT(suspension.roll_axes[0].torque_roll_axis, test::NearVector(printed, printed_digits));
  // The bushing at the pole turns about its centre: the elastic axis is the x axis through the pole.
  EXPECT_THAT(suspension.roll_axes[0].angle, RelativelyNear(std::acos(printed.x()), digits_of_the_angle));
  EXPECT_THAT(suspension.roll_axes[0].distance_at_centre, RelativelyNear(std::hypot(0.2, 0.3), round_off));
}

TEST(Suspension, CouplingAtTheElasticCentreIsSymmetricForAnyElements) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const model::System system = test::checked(test::RandomSystem(seed).description(2, test::RandomDamping::none));
    const modal::BodySuspension suspension = of_body(system, seed % 2);
    const spatial::Matrix6 carry = spatial::rigid_motion(-suspension.elastic->elastic_centre);
    const spatial::Matrix6 there = carry.transpose() * suspension.stiffness * carry;
    const Eigen::Matrix3d coupling = there.topRightCorner<3, 3>();
    EXPECT_LE((coupling - coupling.transpose()).norm(), round_off * suspension.stiffness.norm());
    EXPECT_GT(suspension.elastic->coupling_at_centre, 0.01) << "of skew elements some coupling is left";
  }
}

TEST(Suspension, AStaticMomentTurnsTheBodyAboutTheElasticRollAxis) {
  const model::System system = test::checked(test::RandomSystem(9).description(1, test::RandomDamping::none));
  const modal::BodySuspension suspension = of_body(system);
  for (const modal::RollAxes& axes : suspension.roll_axes) {
    // A motion along the screw with its pitch needs only a multiple of the moment.
    const Eigen::Vector3d theta = axes.elastic_roll_axis.rotation * axes.elastic_roll_axis.direction;
    spatial::Vector6 motion;
    motion << axes.elastic_roll_axis.pitch * theta - theta.cross(axes.elastic_roll_axis.point), theta;
    spatial::Vector6 moment = spatial::Vector6::Zero();
    moment.tail<3>() = axes.torque;
    EXPECT_THAT((suspension.stiffness * motion).eval(), test::NearVector(moment, skew_round_off));
  }
}

TEST(Suspension, ReportsWhatItCannotDetermine) {
  const auto guided = test::project(test::chain({2}, {1800}, {}));
  EXPECT_FALSE(of_body(guided.base().system).elastic.has_value());
  EXPECT_THAT(of_body(guided.base().system).notes, testing::ElementsAre(testing::HasSubstr("constrained")));
  const auto sliding = test::project(
      "trivet = 1\n[bodies.b]\nmass = 2\ninertia = {about = \"center_of_mass\", xx = 1, yy = 1, zz = 1}\n"
      "[elements.e]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\ntranslation = [1e5, 1e5, 0]\nrotation = [1e3, "
      "1e3, 1e3]\n");
  const modal::BodySuspension free = of_body(sliding.base().system);
  EXPECT_TRUE(free.elastic.has_value());
  EXPECT_TRUE(free.roll_axes.empty());
  EXPECT_THAT(free.notes, testing::ElementsAre(testing::HasSubstr("free")));
  const model::System& system = sliding.base().system;
  EXPECT_THROW(
      static_cast<void>(modal::body_suspension(system, assembly::assemble(system), 0, {Eigen::Vector3d::Zero()})),
      foundation::InvalidInput);
}

TEST(FrequencySeparation, IsTheRatioToTheNextModeAndToEveryExcitation) {
  const auto project = test::project(test::chain({1, 1}, {100, 0, 900}, {}));
  const auto rows = modal::frequency_separation(modal::modes(project.base().system), {20});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(*rows[0].ratio_to_next, RelativelyNear(3.0, round_off));
  EXPECT_FALSE(rows[1].ratio_to_next.has_value());
  EXPECT_THAT(rows[0].excitation_ratio[0], RelativelyNear(2.0, round_off));
}

}  // namespace suspension_test
