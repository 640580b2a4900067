// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/moved_machine.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/excited_machine.h"
#include "trivet/report/drawing/result_figures.h"

namespace moved_machine_test {

using namespace trivet;
using testing::HasSubstr;

constexpr double round_off = 1e-12;  // a few operations on lengths near 1

project::Case variant() {
  project::Case machine{.system = model::System::checked(test::machine_on_four_mounts()).value()};
  machine.analyses.modes = true;
  return machine;
}

/// The machine of one body at its pole moves alone; nothing else does.
report::MachineMotion motion(const report::DrawnMachine& machine, const spatial::Vector6& of_pole) {
  report::MachineMotion result;
  result.bodies.assign(machine.bodies.size(), of_pole);
  result.feet.assign(machine.elements.size(), Eigen::Vector3d::Zero());
  return result;
}

TEST(MovedMachine, IsRigidAlsoInALargeRotation) {
  const report::DrawnMachine rest = results::drawn_machine(variant());
  spatial::Vector6 of_pole;
  of_pole << 0.1, -0.2, 0.3, 0.4, 0.5, -0.6;
  const report::DrawnMachine now = report::moved(rest, motion(rest, of_pole), 2, rest.bounds().size());
  ASSERT_EQ(rest.solids.size(), 1u);
  const auto& before = rest.solids[0].surface.vertices;
  const auto& after = now.solids[0].surface.vertices;
  for (std::size_t i = 0; i < before.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NEAR((after[i] - after[j]).norm(), (before[i] - before[j]).norm(), 10 * round_off);
  EXPECT_NEAR((now.points[0].at - after[0]).norm(), (rest.points[0].at - before[0]).norm(), 10 * round_off);
}

TEST(MovedMachine, OfASmallMotionMovesAsUPlusThetaCrossR) {
  const report::DrawnMachine rest = results::drawn_machine(variant());
  spatial::Vector6 of_pole;
  of_pole << 1, 2, -3, 0.5, -4, 2;
  constexpr double small = 1e-6;
  const report::DrawnMachine now = report::moved(rest, motion(rest, of_pole), small, rest.bounds().size());
  const Eigen::Vector3d r = rest.points[0].at - rest.bodies[0].pose.position;
  const Eigen::Vector3d expected = of_pole.head<3>() + of_pole.tail<3>().cross(r);
  EXPECT_NEAR(((now.points[0].at - rest.points[0].at) / small - expected).norm(), 0, 1e-4);  // error ∝ small · |θ|²
}

TEST(MovedMachine, KeepsTheEndsOfItsElementsOnTheGround) {
  const report::DrawnMachine rest = results::drawn_machine(variant());
  const report::DrawnMachine now =
      report::moved(rest, motion(rest, spatial::Vector6::Constant(0.3)), 1, rest.bounds().size());
  for (std::size_t e = 0; e < rest.elements.size(); ++e) {
    EXPECT_EQ(now.elements[e].n, rest.elements[e].n) << e;
    EXPECT_GT((now.elements[e].k - rest.elements[e].k).norm(), 0.1) << e;
  }
}

TEST(DrawnExcursion, ChoosesTheViewInWhichTheMotionIsSeen) {
  const report::DrawnMachine rest = results::drawn_machine(variant());
  const auto best = [&](int coordinate) {
    return report::drawn_excursion(rest, motion(rest, spatial::Vector6::Unit(coordinate))).best_view();
  };
  constexpr std::size_t front = 0, side = 1, top = 2;
  EXPECT_EQ(best(0), front);  // along x, to the right there
  EXPECT_EQ(best(1), side);
  EXPECT_EQ(best(2), front);
  EXPECT_EQ(best(3), side);  // about x, towards the viewer there
  EXPECT_EQ(best(4), front);
  EXPECT_EQ(best(5), top);
}

TEST(DrawnExcursion, IsThatOfTheFarthestPlace) {
  const report::DrawnMachine rest = results::drawn_machine(variant());
  double farthest = 0;
  const auto include = [&](const Eigen::Vector3d& at) { farthest = std::max(farthest, at.head<2>().norm()); };
  for (const Eigen::Vector3d& v : rest.solids[0].surface.vertices) include(v);
  for (const auto& element : rest.elements) include(element.k);
  const auto about_z = motion(rest, spatial::Vector6::Unit(5));
  EXPECT_NEAR(report::drawn_excursion(rest, about_z).largest, farthest, round_off);
}

TEST(MotionOfAMode, MovesTheEndsOnAFoundationWithIt) {
  const project::Case machine = variant();
  const study::CaseResults results = test::results_of_everything();
  for (const modal::Mode& mode : results.modes.list) {
    const report::MachineMotion moves = report::motion_of(mode, machine.system);
    const double deck = mode.coordinates(6);  // after the six of the machine
    EXPECT_NEAR((moves.feet[3] - Eigen::Vector3d(0, 0, deck)).norm(), 0, round_off) << mode.number;
    EXPECT_EQ(moves.feet[0], Eigen::Vector3d::Zero()) << mode.number;
  }
}

TEST(MotionOfAShape, IsThatOfItsPhase) {
  const project::Case machine = variant();
  const study::CaseResults results = test::results_of_everything();
  const response::DeflectionShape& shape = results.shapes->front();
  const double phase = 0.7;
  const report::DrawnMachine rest = results::drawn_machine(machine);
  const report::DrawnMachine now =
      report::moved(rest, report::motion_of(shape, machine.system, phase), 1, rest.bounds().size());
  const Eigen::Vector3d expected = response::displaced(shape.points[0], phase, 1);
  EXPECT_NEAR((now.points[0].at - expected).norm(), 0, 1e-6);  // motions of 1e-4 m, the rotation is not linear
}

TEST(ModeFigures, HaveFrequencyNameAndViewAndAreAtMostEight) {
  const study::CaseResults results = test::results_of_everything();
  const std::vector<report::Figure> figures = report::mode_figures(variant(), results);
  ASSERT_EQ(figures.size(), 7u);  // six of the machine, one of the deck
  EXPECT_THAT(figures[0].svg, HasSubstr(">1: "));
  EXPECT_THAT(figures[0].svg, HasSubstr(" Hz</text>"));
  EXPECT_THAT(figures[0].title, HasSubstr(results.modes.list[0].name));
  study::CaseResults many = results;
  for (int i = 0; i < 3; ++i) many.modes.list.push_back(results.modes.list.back());
  EXPECT_EQ(report::mode_figures(variant(), many).size(), 8u);
  many.modes.list[0].angular_frequency = 0;
  EXPECT_THAT(report::mode_figures(variant(), many)[0].svg, HasSubstr(">2: "));
}

}  // namespace moved_machine_test
