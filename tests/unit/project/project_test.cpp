// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/projects.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/text/embedded_text.h"
#include "trivet/results/format/written_results.h"

namespace project_test {

using namespace trivet;

const char* const two_bodies = R"(
trivet = 1
[bodies.zulu]
mass = 1
free = ["z", "x"]
[bodies.alpha]
mass = 2
free = ["y"]
[elements.k]
type = "bushing"
on = "zulu"
at = [0, 0, 0]
translation = [100, 200, 300]
damping = {loss_factor = 0.1}
[elements.c]
type = "damper"
on = "alpha"
at = [0, 0, 0]
from = "zulu"
axis = "y"
coefficient = 7
[cases.stiff]
elements.k.scale = 4
[cases."other damping"]
elements.k.damping = {proportional = 0.5}
[cases."more loss"]
elements.k.damping.loss_factor = 0.3
)";

TEST(Project, BodiesKeepTheOrderOfTheFile) {
  const auto project = test::project(two_bodies);
  ASSERT_EQ(project.base().system.bodies().size(), 2u);
  EXPECT_EQ(project.base().system.bodies()[0].name, "zulu");
}

TEST(Project, CasesMergeKeyByKeyAndReplaceTablesInBraces) {
  const auto project = test::project(two_bodies);
  ASSERT_EQ(project.cases.size(), 4u);
  EXPECT_EQ(project.find("stiff")->system.elements()[0].law.scale, 4);
  EXPECT_TRUE(std::holds_alternative<elements::LossFactor>(project.find("stiff")->system.elements()[0].law.damping));
  EXPECT_TRUE(std::holds_alternative<elements::ProportionalDamping>(
      project.find("other damping")->system.elements()[0].law.damping));
  EXPECT_EQ(std::get<elements::LossFactor>(project.find("more loss")->system.elements()[0].law.damping).value, 0.3);
  EXPECT_EQ(project.find("stiff")->changes, std::vector<std::string>{"elements.k.scale = 4"});
}

TEST(Project, SettingsChangeTheBaseAndEveryCase) {
  const auto project = test::project(two_bodies, {"bodies.zulu.mass=3 kg", "elements.k.translation=[1,2,3]"});
  EXPECT_EQ(project.base().system.bodies()[0].mass.mass, 3);
  EXPECT_EQ(project.find("stiff")->system.bodies()[0].mass.mass, 3);
  EXPECT_NE(project.sha256, test::project(two_bodies).sha256) << "a setting is part of the input";
}

TEST(Project, ASettingOnAnUnknownThingIsAnErrorWithASuggestion) {
  const auto refused = judging::project_from_text(two_bodies, "t.toml", {"bodies.zuli.mass=3"});
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(foundation::message(refused.error().list()[0]), testing::HasSubstr("did you mean \"zulu\""));
}

TEST(Project, ADamperHasNoStiffnessAndActsAlongItsAxis) {
  const auto project = test::project(two_bodies);
  const auto assembled = assembly::assemble(project.base().system);
  // zulu moves in x and z, alpha in y: the damper along y acts only on alpha's coordinate.
  EXPECT_EQ(assembled.matrices.B(2, 2), 7);
  constexpr double one_rounding = 1e-15;  // an axis along y has components of 6e-17 along x and z
  EXPECT_NEAR(assembled.matrices.B.cwiseAbs().sum(), 7, one_rounding);
  EXPECT_EQ(assembled.matrices.K(2, 2), 0);
}

TEST(Project, TheStarterFileRuns) {
  const auto project = test::project(project::starter_text());
  for (const auto& variant : project.cases) {
    const auto results = study::case_results(variant, variant.analyses);
    EXPECT_TRUE(results.response && results.peaks && results.statics);
    EXPECT_EQ(results.limits.size(), 1u);
  }
}

TEST(Project, TheSameInputGivesTheSameBytes) {
  const auto a = test::project(project::starter_text()), b = test::project(project::starter_text());
  const auto results_a = study::case_results(a.base(), a.base().analyses),
             results_b = study::case_results(b.base(), b.base().analyses);
  EXPECT_EQ(results::result_json("response", a.base(), results_a),
            results::result_json("response", b.base(), results_b));
  EXPECT_EQ(results::result_json("peaks", a.base(), results_a), results::result_json("peaks", b.base(), results_b));
}

TEST(Project, ElementsAreCarriedBetweenTurnedBodies) {
  // A damper along the ground's z between two bodies with different orientations must act along z only.
  const auto project = test::project(R"(
trivet = 1
[bodies.a]
mass = 1
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
orientation = {axis = "x", angle = "90 deg"}
[bodies.b]
mass = 1
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
orientation = {axis = "y", angle = "-30 deg"}
position = [0, 0, 1]
[elements.k]
type = "damper"
on = "b"
at = [0, 0, 0]
from = "a"
from_at = [0, 0, 0]
coefficient = 10
)");
  constexpr double round_off = 1e-12;  // two rotations, products of numbers up to 10
  const auto m = assembly::assemble(project.base().system).matrices;
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(12);
  velocity(1) = 1;  // a's y axis is the ground's z
  EXPECT_NEAR(velocity.dot(m.B * velocity), 10, round_off);
  velocity.setZero();
  velocity(0) = 1;
  EXPECT_NEAR(velocity.dot(m.B * velocity), 0, round_off);
}

}  // namespace project_test
