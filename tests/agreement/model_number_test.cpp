// SPDX-License-Identifier: BSD-3-Clause
// A parameter of `explain` changes the same quantity as the number of the project file with that name.
#include <gmock/gmock.h>

#include <filesystem>

#include "support/projects.h"
#include "trivet/assembly/assembled.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"
#include "trivet/judging/read_project.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/rest/rest_position.h"
#include "trivet/project/model_number.h"
#include "trivet/project/project.h"
#include "trivet/project/text/known_model.h"
#include "trivet/response/sensitivity/model_parameters.h"

namespace model_number_test {

using namespace trivet;

constexpr double round_off =
    1e-12;  // of the largest entry: factors are formed as 1 + 0.01 in one way and 1.01 in the other

Eigen::MatrixXcd dynamic_stiffness(const model::System& system) {
  constexpr double omega = 7;
  return assembly::assemble(system).dynamic_stiffness(omega, omega);
}

/// Value of a number of the file after the change by explain: relative to the written value, or added to it.
double changed_value(double before, const response::Parameter& parameter) {
  const bool added = parameter.change == "+1 mm" || parameter.change.find("√") != std::string::npos;
  return added ? before + parameter.size : before * (1 + parameter.size);
}

std::vector<std::filesystem::path> examples() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(TRIVET_SOURCE_DIR) / "examples"))
    if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "rubber_mounts" &&
        entry.path().parent_path().filename() != "catalogue")
      found.push_back(entry.path());  // rubber_mounts needs a mesh
  return found;
}

TEST(ModelNumbers, AreThoseOfExplainByTheirPaths) {
  int compared = 0;
  for (const std::filesystem::path& file : examples()) {
    const auto project = judging::read_project(file);
    ASSERT_TRUE(project) << file << ": " << foundation::message(project.error().list().front());
    const project::Case& base = project->base();
    for (const response::Parameter& parameter : response::model_parameters(base.system)) {
      const project::ModelNumber number(parameter.name, "");
      const std::optional<double> before = number.read(base);
      ASSERT_TRUE(before) << file << ": " << parameter.name;
      const auto by_file = judging::changed_system(base, {{number, changed_value(*before, parameter)}});
      ASSERT_TRUE(by_file) << file << ": " << parameter.name << ": "
                           << foundation::message(by_file.error().list().front());
      const model::System by_explain = response::changed(base.system, parameter, parameter.size);
      const Eigen::MatrixXcd expected = dynamic_stiffness(model::is_nonlinear(by_explain)
                                                              ? nonlinear::rest_position(by_explain).system
                                                              : by_explain),
                             found = dynamic_stiffness(*by_file);
      EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), round_off * expected.cwiseAbs().maxCoeff())
          << file << ": " << parameter.name;
      const Eigen::MatrixXcd before_change = dynamic_stiffness(base.system);
      EXPECT_EQ(found == before_change, expected == before_change)
          << file << ": " << parameter.name << " changes nothing";
      ++compared;
    }
  }
  EXPECT_GT(compared, 300);
}

constexpr const char* machine = R"(
trivet = 1
[bodies.machine]
mass = 100
inertia = {about = "center_of_mass", xx = 8, yy = 9, zz = 10}
[elements."front left"]
type = "bushing"
on = "machine"
at = ["0.3 m", "200 mm", 0]
translation = [1e5, 1e5, 2e5]
[elements.rear]
type = "bushing"
on = "machine"
at = [-0.3, -0.2, 0]
translation = [1e5, 1e5, 2e5]
[elements.side]
type = "bushing"
on = "machine"
at = [0, 0.3, 0.1]
translation = [1e5, 1e5, 2e5]
)";

TEST(ModelNumbers, ArraysAreListedByTheirComponents) {
  const auto project = judging::project_from_text(machine, "machine.toml");
  ASSERT_TRUE(project);
  const project::ModelNumber y("elements.\"front left\".at.y", "mm"), z("elements.rear.translation.z", "kN/m");
  EXPECT_DOUBLE_EQ(y.read(project->base()).value(), 200);
  EXPECT_DOUBLE_EQ(z.read(project->base()).value(), 200);
  const auto changed = judging::changed_system(project->base(), {{y, 250}, {z, 300}});
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->elements()[0].k.at, Eigen::Vector3d(0.3, 0.25, 0));
  const auto whole = judging::project_from_text(
      machine, "machine.toml",
      {"elements.\"front left\".at = [0.3, 0.25, 0]", "elements.rear.translation = [1e5, 1e5, 3e5]"});
  ASSERT_TRUE(whole);
  EXPECT_EQ(dynamic_stiffness(whole->base().system), dynamic_stiffness(*changed));
}

TEST(ModelNumbers, LeaveOtherNumbersUnchanged) {
  const auto project = judging::project_from_text(
      machine, "machine.toml", {"bodies.machine.mass_about_center = 1.1", "elements.side.moved.x = 0.01"});
  ASSERT_TRUE(project);
  for (const auto& [path, value] : {std::pair{"elements.rear.scale", 1.2},
                                    {"bodies.machine.position.x", 0.1},
                                    {"elements.side.stiffness_factor.z", 1.1},
                                    {"bodies.machine.mass", 120.0}}) {
    const auto quick = judging::changed_system(project->base(), {{project::ModelNumber(path, ""), value}});
    const auto read_again =
        judging::project_from_text(machine, "machine.toml",
                                   {"bodies.machine.mass_about_center = 1.1", "elements.side.moved.x = 0.01",
                                    path + (" = " + std::to_string(value))});
    ASSERT_TRUE(quick && read_again) << path;
    EXPECT_EQ(dynamic_stiffness(*quick), dynamic_stiffness(read_again->base().system)) << path;
  }
}

constexpr const char* pair_of_masses = R"(
trivet = 1
[bodies.lower]
mass = 3
free = ["z"]
[bodies.upper]
mass = 2
free = ["z"]
position = [0, 0, 0.5]
[element_types.spring]
type = "bushing"
translation = [1, 1, 1000]
[elements.foot]
type = "spring"
on = "lower"
at = [0, 0, 0]
scale = 2
[elements.between]
type = "spring"
on = "upper"
from = "lower"
at = [0, 0, 0]
)";

/// Masses and springs by hand: A = diag(3, 2), K from 2 k + k and k.
TEST(ModelNumbers, ReachElementsThroughTheirTypesAndBodies) {
  const auto project = judging::project_from_text(pair_of_masses, "pair.toml");
  ASSERT_TRUE(project);
  const auto stiffness = [&](const std::string& path, double value) {
    const auto system = judging::changed_system(project->base(), {{project::ModelNumber(path, ""), value}});
    EXPECT_TRUE(system) << path;
    return assembly::assemble(*system).matrices.K;
  };
  const auto expected = [](double foot, double between) {
    return Eigen::MatrixXd(Eigen::Matrix2d({{foot + between, -between}, {-between, between}}));
  };
  EXPECT_TRUE(stiffness("element_types.spring.translation.z", 1500).isApprox(expected(3000, 1500), round_off));
  EXPECT_TRUE(stiffness("element_types.spring.scale", 3).isApprox(expected(6000, 3000), round_off));
  EXPECT_TRUE(stiffness("elements.foot.scale", 1).isApprox(expected(1000, 1000), round_off));
  EXPECT_TRUE(stiffness("elements.foot.stiffness_factor.all", 1.5).isApprox(expected(3000, 1000), round_off));
  EXPECT_TRUE(stiffness("elements.foot.stiffness_factor.z", 1.5).isApprox(expected(3000, 1000), round_off));
  EXPECT_TRUE(stiffness("bodies.upper.mass", 7).isApprox(expected(2000, 1000), round_off));
  const auto share = project::ModelNumber("elements.between.scale", "%"),
             lift = project::ModelNumber("elements.between.moved.z", "mm");
  EXPECT_DOUBLE_EQ(share.read(project->base()).value(), 100);
  EXPECT_DOUBLE_EQ(lift.read(project->base()).value(), 0);
}

TEST(KnownModel, SharesUnchangedPartsAndHasNoAdjustments) {
  const auto project =
      judging::project_from_text(pair_of_masses, "pair.toml", {"elements.foot.stiffness_factor.z = 1.1"});
  ASSERT_TRUE(project);
  const project::Case& base = project->base();
  const project::KnownModel known{base.document, base.system.description()};
  const project::Node* elements = base.document.find("elements");
  EXPECT_TRUE(known.unchanged("elements", "between", *elements->find("between")));
  EXPECT_FALSE(known.unchanged("elements", "foot", *elements->find("foot"))) << "its adjustment is in the description";
  EXPECT_FALSE(known.unchanged("elements", "between", *elements->find("foot")));
}

}  // namespace model_number_test
