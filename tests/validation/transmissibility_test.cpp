// SPDX-License-Identifier: BSD-3-Clause
// Transmissibility of simple systems against closed forms.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/guided_mass.h"
#include "support/matchers.h"
#include "support/solved_system.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/machinery/transmissibility.h"

namespace transmissibility_test {

using namespace trivet;
using test::RelativelyNear;
constexpr double round_off = 1e-10;    // solves of one coordinate, with roots and heights from them
constexpr double flat_maximum = 1e-8;  // the place of a maximum is known to the root of round-off
constexpr double infinity = std::numeric_limits<double>::infinity();

/// |F_T/F| = |X/Y| of one degree of freedom.
double textbook_transmissibility(double ratio, double r) {
  const double c = 4 * ratio * ratio * r * r;
  return std::sqrt((1 + c) / (std::pow(1 - r * r, 2) + c));
}

TEST(Transmissibility, OneMassHasTheTextbookCurve) {
  constexpr double natural = 20;
  for (const double ratio : {0.02, 0.1, 0.5, 1.5}) {
    const test::SolvedSystem solved(test::guided_mass(7, natural, ratio));
    const auto force = response::force_transmission(solved.system, solved.assembled, {0, Eigen::Vector3d::Zero(), {}});
    const auto motion = response::displacement_transmission(solved.system, solved.assembled, {"machine"}, {});
    for (const auto* way : {&force, &motion}) {
      const auto curves = response::frequency_response(solved.assembled, way->channels, way->loading,
                                                       {0.5 * natural, natural, 3 * natural});
      for (const response::Curve& curve : curves.curves) {
        EXPECT_EQ(curve.unit, "1");
        EXPECT_THAT(std::abs(curve.value(0)), RelativelyNear(textbook_transmissibility(ratio, 0.5), round_off));
        EXPECT_THAT(std::abs(curve.value(1)), RelativelyNear(textbook_transmissibility(ratio, 1), round_off));
        EXPECT_THAT(std::abs(curve.value(2)), RelativelyNear(textbook_transmissibility(ratio, 3), round_off));
      }
      const response::Peaks peaks = solved.peaks(way->channels, way->loading);
      const double r2 = (std::sqrt(1 + 8 * ratio * ratio) - 1) / (4 * ratio * ratio);
      EXPECT_THAT(peaks.list[0].angular_frequency, RelativelyNear(natural * std::sqrt(r2), flat_maximum));
      EXPECT_THAT(peaks.list[0].amplitude, RelativelyNear(textbook_transmissibility(ratio, std::sqrt(r2)), round_off));
      for (const response::Crossover& crossover : response::crossovers(solved.assembled, *way, peaks)) {
        EXPECT_THAT(crossover.angular_frequency.value(), RelativelyNear(std::numbers::sqrt2 * natural, round_off))
            << "for any viscous damping";
        EXPECT_EQ(crossover.proven_to, infinity);
      }
    }
    EXPECT_THAT(force.channels,
                testing::ElementsAre(testing::Field(&assembly::Channel::name, "ground"),
                                     testing::Field(&assembly::Channel::name, "mount")));
  }
}

TEST(Transmissibility, HasTheIsolationOfVdi2062) {
  // Undamped: η = (n² − 2)/(n² − 1).
  constexpr double efficiency[] = {0.6666666666666666, 0.875, 0.9333333333333333, 0.9583333333333334};
  constexpr double isolation_db[] = {9.542425094393248, 18.06179973983887, 23.521825181113627, 27.604224834232124};
  const test::SolvedSystem solved(test::guided_mass(4, 10, 0));
  const auto force = response::force_transmission(solved.system, solved.assembled, {0, Eigen::Vector3d::Zero(), {}});
  const auto curves = response::frequency_response(solved.assembled, force.channels, force.loading, {20, 30, 40, 50});
  for (int i = 0; i < 4; ++i) {
    const double ratio = std::abs(curves.curves[0].value(i));
    EXPECT_THAT(response::isolation_efficiency(ratio), RelativelyNear(efficiency[i], round_off));
    EXPECT_THAT(response::transmissibility_level(ratio), RelativelyNear(-isolation_db[i], round_off));
  }
  const response::Peaks peaks = solved.peaks(force.channels, force.loading);
  EXPECT_THAT(response::crossovers(solved.assembled, force, peaks)[0].angular_frequency.value(),
              RelativelyNear(10 * std::numbers::sqrt2, round_off));
}

TEST(Transmissibility, RelativeMotionHasNoCrossover) {
  // The relative motion over a base motion tends to 1 from above: |r²/(1 − r²)|.
  const test::SolvedSystem solved(test::guided_mass(4, 10, 0.05));
  auto motion = response::displacement_transmission(solved.system, solved.assembled, {"machine"}, {});
  motion.channels = {solved.channels({"machine.relative"})[2]};
  const response::Peaks peaks = solved.peaks(motion.channels, motion.loading);
  EXPECT_FALSE(response::crossovers(solved.assembled, motion, peaks)[0].angular_frequency.has_value());
}

TEST(Transmissibility, RejectsARatioOfDifferentUnits) {
  const test::SolvedSystem solved(test::guided_mass(4, 10, 0.05));
  const model::Direction up, turn{Eigen::Vector3d::UnitX(), true};
  EXPECT_THAT(
      [&] { (void)response::force_transmission(solved.system, solved.assembled, {0, {}, up}, turn); },
      testing::ThrowsMessage<foundation::InvalidInput>(testing::HasSubstr("a moment over a force has the unit m")));
  EXPECT_THAT(
      [&] { (void)response::displacement_transmission(solved.system, solved.assembled, {"machine"}, turn, up); },
      testing::ThrowsMessage<foundation::InvalidInput>(
          testing::HasSubstr("a translation over a rotation has the unit m")));
  EXPECT_THAT(
      [&] {
        (void)response::force_transmission(solved.system, solved.assembled, {0, {}, {Eigen::Vector3d::Zero(), false}});
      },
      testing::ThrowsMessage<foundation::InvalidInput>(testing::HasSubstr("length > 0")));
  EXPECT_THROW((void)response::displacement_transmission(solved.system, solved.assembled, {"mount"}, up),
               foundation::InvalidInput);
}

TEST(Transmissibility, HasTheDirectionOfAForceOfTheModel) {
  model::Description d = test::guided_mass(4, 10, 0.05);
  d.bodies[0].pose.rotation << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // body z along ground x
  d.elements[0].k.axes = d.bodies[0].pose.rotation.transpose();
  d.excitations = {test::vertical_force("push", 0, std::polar(3.0, 0.7)), test::vertical_force("both", 0, 1),
                   test::vertical_force("round", 0, 1)};
  d.excitations[1].action.amplitude(3) = 1;
  d.excitations[2].action.amplitude(1) = {0, 1};
  const model::System system = test::checked(d);
  const model::AppliedForce push = model::applied_force(system, "push");
  constexpr double last_digit = 4 * test::epsilon;  // a rotation and a root
  EXPECT_NEAR((push.direction.axis.normalized() - Eigen::Vector3d::UnitX()).norm(), 0, last_digit);
  EXPECT_FALSE(push.direction.rotation);
  EXPECT_THAT([&] { (void)model::applied_force(system, "both"); },
              testing::ThrowsMessage<foundation::InvalidInput>(testing::HasSubstr("a force and a moment")));
  EXPECT_THAT([&] { (void)model::applied_force(system, "round"); },
              testing::ThrowsMessage<foundation::InvalidInput>(testing::HasSubstr("differ in phase")));
  EXPECT_THROW((void)model::applied_force(system, "none"), foundation::InvalidInput);
}

}  // namespace transmissibility_test
