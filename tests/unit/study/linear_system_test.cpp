// SPDX-License-Identifier: BSD-3-Clause
// Matrices, state space and sweep of one mass on one spring, compared with the formulas.
#include "trivet/study/explain/linear_system.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/map/design_sweep.h"

namespace linear_system_test {

using namespace trivet;

constexpr double m = 4, k = 1e4, b = 30, force = 7;
constexpr double round_off = 1e-12;

/// A mass guided along z, on a spring and a dashpot, under a harmonic force.
std::string oscillator() {
  return R"(trivet = 1
[bodies.mass]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [1, 1, 1e4]
damping = {translation = [0, 0, 30]}
[excitations.push]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 7]
[analyses]
response = {band = ["1 Hz", "30 Hz"]}
)";
}

TEST(SystemMatrices, AreMassDampingAndStiffness) {
  const project::Project project = test::project(oscillator());
  const study::SystemMatrices found = study::system_matrices(project.base());
  EXPECT_EQ(found.coordinates, std::vector<std::string>{"mass.z"});
  EXPECT_EQ(found.units, std::vector<std::string>{"m"});
  EXPECT_NEAR(found.matrices.A(0, 0), m, round_off * m);
  EXPECT_NEAR(found.matrices.B(0, 0), b, round_off * b);
  EXPECT_NEAR(found.matrices.K(0, 0), k, round_off * k);
  EXPECT_TRUE(found.exact);
  EXPECT_NEAR(std::abs(found.load.at(3.0)(0) - force), 0, round_off * force);
}

TEST(LinearSystem, HasDisplacementsAndVelocitiesAsStates) {
  const project::Project project = test::project(oscillator());
  const study::LinearSystem found = study::linear_system(project.base(), {"mass"});
  ASSERT_EQ(found.states.size(), 2);
  EXPECT_EQ(found.states[0].name, "mass.z");
  EXPECT_EQ(found.states[1].name, "mass.z.velocity");
  ASSERT_EQ(found.inputs.size(), 1);
  EXPECT_EQ(found.inputs[0].name, "push.force.z");
  EXPECT_EQ(found.inputs[0].unit, "N");
  Eigen::Matrix2d a;
  a << 0, 1, -k / m, -b / m;
  EXPECT_LT((found.A - a).cwiseAbs().maxCoeff(), round_off * k / m);
  EXPECT_LT((found.B - Eigen::Vector2d(0, 1 / m)).cwiseAbs().maxCoeff(), round_off / m);
  EXPECT_LT((found.C - Eigen::RowVector2d(1, 0)).cwiseAbs().maxCoeff(), round_off);
  EXPECT_TRUE(found.D.isZero(0));
}

TEST(LinearSystem, RejectsLossFactors) {
  std::string text = oscillator();
  text.replace(text.find("{translation = [0, 0, 30]}"), 26, "{loss_factor = 0.1}");
  EXPECT_THROW(static_cast<void>(study::linear_system(test::project(text).base(), {})), foundation::NotComputable);
}

TEST(DesignSweep, FindsThePeakOfEachMassAndNamesMassesThatCannotBe) {
  const project::Project project = test::project(oscillator());
  const study::DesignSweep found =
      study::design_sweep(project.base(), {.numbers = {{"bodies.mass.mass", {4, -1, 9}}}, .of = {"mass"}});
  EXPECT_EQ(found.results, std::vector<std::string>{"mass.z"});
  ASSERT_EQ(found.highest.rows(), 3);
  for (const auto& [row, mass] : {std::pair{0, 4.0}, {2, 9.0}}) {
    const double ratio = b / (2 * std::sqrt(k * mass)), peak = force / k / (2 * ratio * std::sqrt(1 - ratio * ratio));
    EXPECT_NEAR(found.highest(row, 0), peak, 1e-9 * peak);
  }
  EXPECT_TRUE(std::isnan(found.highest(1, 0)));
  EXPECT_EQ(found.without_model, 1);
  EXPECT_EQ(found.in_kernels + found.one_by_one, 2);
  EXPECT_THAT(found.first_failure, testing::HasSubstr("mass"));
}

/// Two masses that only a spring and a dashpot join. Under a pair of opposite forces the rigid-body mode does not move,
/// and a moves by m_b/(m_a + m_b) of the relative motion of the reduced mass; under one force it drifts without bound.
TEST(DesignSweep, TreatsRigidBodyModesAsTheRequirementsDo) {
  const std::string head = R"(trivet = 1
[bodies.a]
mass = 4
free = ["z"]
[bodies.b]
mass = 12
free = ["z"]
[elements.spring]
type = "bushing"
on = "b"
at = [0, 0, 0]
from = "a"
from_at = [0, 0, 0]
translation = [1, 1, 1e4]
damping = {translation = [0, 0, 30]}
[excitations.push]
type = "harmonic"
on = "a"
at = [0, 0, 0]
force = [0, 0, 7]
)",
                    pull = "[excitations.pull]\ntype = \"harmonic\"\non = \"b\"\nat = [0, 0, 0]\nforce = [0, 0, -7]\n";
  const study::SweepRequest request{
      .numbers = {{"bodies.a.mass", {4, 6}}}, .of = {"a.z"}, .band = assembly::Band{0, 200}};
  const study::DesignSweep found = study::design_sweep(test::project(head + pull).base(), request);
  for (const auto& [row, mass] : {std::pair{0, 4.0}, {1, 6.0}}) {
    const double reduced = mass * 12 / (mass + 12), ratio = b / (2 * std::sqrt(k * reduced)),
                 peak = force / k / (2 * ratio * std::sqrt(1 - ratio * ratio)) * 12 / (mass + 12);
    EXPECT_NEAR(found.highest(row, 0), peak, 1e-9 * peak);
  }
  const study::DesignSweep drifting = study::design_sweep(test::project(head).base(), request);
  EXPECT_TRUE(std::isinf(drifting.highest(0, 0)));
}

TEST(DesignSweep, RejectsAnEmptySweep) {
  const project::Project project = test::project(oscillator());
  EXPECT_THROW(static_cast<void>(study::design_sweep(project.base(), {})), foundation::InvalidInput);
}

}  // namespace linear_system_test
